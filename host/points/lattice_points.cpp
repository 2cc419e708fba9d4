#include "points/lattice_points.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/hash.h"
#include "base/parallel.h"

namespace capcon {

namespace {

constexpr std::uint64_t kShiftStream = 0x73686966;

/// Squared length of the shortest vector (q, r), q, r in Z, r = q g mod n; or at most `bound`, then that of
/// some short vector.
std::uint64_t shortest2(std::uint64_t n, std::uint64_t g, std::uint64_t bound) {
  std::uint64_t r_last = n, q_last = 0, r = g, q = 1;
  std::uint64_t best = n * n;
  for (;;) {
    best = std::min(best, q * q + r * r);
    // All that follow are longer than q.
    if (best <= bound || q * q >= best || r == 0) return best;
    const std::uint64_t times = r_last / r;
    const std::uint64_t r_next = r_last - times * r, q_next = q_last + times * q;
    r_last = r, q_last = q;
    r = r_next, q = q_next;
  }
}

}  // namespace

std::uint32_t maximin_generator(std::uint32_t n) {
  if (n < 2) return 0;
  // g and n - g are mirror images. Some good lattice first, so that the search dismisses the others early.
  const std::uint64_t last = n / 2;
  const std::uint64_t golden = std::min<std::uint64_t>(last, std::llround(n * 0.38196601125010515));
  std::uint64_t floor2 = 0;
  for (std::uint64_t g = golden > 200 ? golden - 200 : 0; g <= std::min(last, golden + 200); ++g)
    floor2 = std::max(floor2, shortest2(n, g, floor2));
  struct Best {
    std::uint64_t length2 = 0;
    std::uint32_t g = 0;
  };
  constexpr std::uint64_t kBlock = 1 << 16;
  std::vector<Best> blocks(last / kBlock + 1);
  parallel_for(blocks.size(), [&](std::size_t block) {
    Best best{floor2 - 1, 0};  // as good as that is good enough: the least g counts
    for (std::uint64_t g = block * kBlock; g < std::min(last + 1, (block + 1) * kBlock); ++g) {
      const std::uint64_t length2 = shortest2(n, g, best.length2);
      if (length2 > best.length2) best = {length2, static_cast<std::uint32_t>(g)};
    }
    blocks[block] = best;
  });
  return std::max_element(blocks.begin(), blocks.end(),
                          [](const Best& a, const Best& b) { return a.length2 < b.length2; })
      ->g;
}

Points lattice_points(LatticeKind kind, std::uint32_t n) {
  Points points(n);
  const std::uint64_t g = kind == LatticeKind::kMaximin ? maximin_generator(n) : 0;
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 / phi
  for (std::uint64_t k = 0; k < n; ++k) {
    const double y = kind == LatticeKind::kMaximin ? static_cast<double>(k * g % n) / n
                                                   : static_cast<double>((k * kGolden) >> 11) * 0x1p-53;
    points[k] = {static_cast<double>(k) / n, y};
  }
  return points;
}

void shift_randomly(Points& points, std::uint64_t seed) {
  const glm::dvec2 shift(uniform64(seed, kShiftStream, 0), uniform64(seed, kShiftStream, 1));
  for (glm::dvec2& p : points) {
    p += shift;
    for (int axis = 0; axis < 2; ++axis) p[axis] -= p[axis] >= 1 ? 1 : 0;
  }
}

}  // namespace capcon
