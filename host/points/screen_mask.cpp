#include "points/screen_mask.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <glm/vec3.hpp>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "points/cell_swaps.h"

namespace capcon {
namespace {

constexpr std::uint64_t kSwapStream = 0x6d61736b;
constexpr std::uint32_t kSymmetries = 8, kColumns = ScreenMask::kColumns;
constexpr int kReach = 5;              // pixels; the weight beyond is below 0.002
constexpr std::uint32_t kTries = 600;  // swaps tried for each place

/// The composition table: after[g][h] is the symmetry that does h, then g.
struct Group {
  std::array<std::array<std::uint32_t, kSymmetries>, kSymmetries> after{};

  explicit Group(EnsembleDomain domain) {
    const auto is_near = [](glm::dvec2 a, glm::dvec2 b) {
      return std::abs(std::remainder(a.x - b.x, 1.0)) + std::abs(a.y - b.y) < 1e-9;
    };
    const glm::dvec2 p(0.13, 0.37);  // on no axis of symmetry
    for (std::uint32_t g = 0; g < kSymmetries; ++g) {
      for (std::uint32_t h = 0; h < kSymmetries; ++h) {
        const glm::dvec2 both = apply_symmetry(domain, g, apply_symmetry(domain, h, p));
        for (std::uint32_t k = 0; k < kSymmetries; ++k)
          if (is_near(both, apply_symmetry(domain, k, p))) after[g][h] = k;
      }
    }
  }
};

std::vector<glm::vec3> places(const Ensemble& e, EnsembleDomain domain, std::uint32_t symmetry) {
  std::vector<glm::vec3> result;
  for (const std::uint32_t c : e.cells) {
    const glm::dvec2 centre((c % e.columns + 0.5) / e.columns, (c / e.columns + 0.5) / e.rows);
    result.push_back(spread_place(domain, apply_symmetry(domain, symmetry, centre)));
  }
  return result;
}

template <EnsembleDomain domain>
float mean_spread(const glm::vec3* a, const glm::vec3* b, std::uint32_t n) {
  const SpreadWeights weights = spread_weights(n);
  double sum = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    float row = 0;
    for (std::uint32_t j = 0; j < n; ++j)
      row += spread_distance<domain>(a[i].x - b[j].x, a[i].y - b[j].y, a[i].z - b[j].z, weights);
    sum += row;
  }
  return static_cast<float>(sum / n / n);
}

/// spread[k][l]: of the points under keys k and l.
class KeySpreads {
 public:
  KeySpreads(const Ensemble& e, EnsembleDomain domain)
      : keys_(e.sets * kSymmetries), spread_(std::size_t(keys_) * keys_) {
    const auto n = static_cast<std::uint32_t>(e.cells.size() / e.sets);
    const Group group(domain);
    std::vector<std::vector<glm::vec3>> turned;
    for (std::uint32_t g = 0; g < kSymmetries; ++g) turned.push_back(places(e, domain, g));
    // Turning both changes nothing: only the turn of one against the other counts.
    parallel_for(e.sets, [&](std::size_t s) {
      for (std::size_t t = 0; t < e.sets; ++t) {
        for (std::uint32_t g = 0; g < kSymmetries; ++g) {
          const glm::vec3 *a = &turned[0][s * n], *b = &turned[g][t * n];
          const float spread = domain == EnsembleDomain::square ? mean_spread<EnsembleDomain::square>(a, b, n)
                               : domain == EnsembleDomain::disk
                                   ? mean_spread<EnsembleDomain::disk>(a, b, n)
                                   : mean_spread<EnsembleDomain::cylinder>(a, b, n);
          for (std::uint32_t h = 0; h < kSymmetries; ++h)
            spread_[(s * kSymmetries + h) * keys_ + t * kSymmetries + group.after[h][g]] = spread;
        }
      }
    });
  }
  std::uint32_t keys() const { return keys_; }
  float operator()(std::uint32_t k, std::uint32_t l) const { return spread_[std::size_t(k) * keys_ + l]; }

 private:
  std::uint32_t keys_;
  std::vector<float> spread_;
};

class Annealing {
 public:
  Annealing(ScreenMask& mask, const KeySpreads& spreads) : mask_(mask), spreads_(spreads) {
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x)
        if ((x != 0 || y != 0) && x * x + y * y <= kReach * kReach)
          // A Gaussian of sigma 1, correlated with itself.
          near_.push_back({x, y, static_cast<float>(std::exp(-(x * x + y * y) / 4.0))});
  }

  void run() {
    const auto count = static_cast<std::uint32_t>(mask_.keys.size());
    double size = 0;  // of the changes at the start
    for (std::uint32_t i = 0; i < 256; ++i) size += std::abs(gain(place(i, 1), place(i, 2))) / 256;
    const std::uint64_t tries = std::uint64_t(kTries) * count;
    double heat = size;
    const double cooling = std::pow(1e-3, 1.0 / kTries);
    for (std::uint64_t t = 0; t < tries; ++t) {
      if (t % count == 0) heat *= cooling;
      const std::uint64_t word = mix64(1, kSwapStream, t);
      const auto a = static_cast<std::uint32_t>(word % count),
                 b = static_cast<std::uint32_t>((word >> 20) % count);
      if (a == b) continue;
      const double better = gain(a, b);
      if (better > 0 || std::exp(better / heat) > static_cast<double>(word >> 40) * 0x1p-24)
        std::swap(mask_.keys[a], mask_.keys[b]);
    }
  }

 private:
  struct Near {
    int x, y;
    float weight;
  };

  std::uint32_t place(std::uint32_t i, std::uint32_t which) const {
    return static_cast<std::uint32_t>(mix64(which, kSwapStream + 1, i) % mask_.keys.size());
  }

  /// By how much the weighted spread to the neighbours grows if the keys of a and b change places.
  double gain(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t of_a = mask_.keys[a], of_b = mask_.keys[b];
    if (of_a == of_b) return 0;
    return gain_at(a, b, of_a, of_b) + gain_at(b, a, of_b, of_a);
  }

  double gain_at(std::uint32_t at, std::uint32_t other, std::uint32_t was, std::uint32_t is) const {
    const int x = static_cast<int>(at % kColumns), y = static_cast<int>(at / kColumns),
              rows = static_cast<int>(mask_.rows);
    float sum = 0;
    for (const Near& n : near_) {
      const auto k = static_cast<std::uint32_t>((x + n.x) & int(kColumns - 1)) +
                     kColumns * static_cast<std::uint32_t>((y + n.y + rows) % rows);
      if (k == other) continue;  // their own distance stays
      const std::uint32_t key = mask_.keys[k];
      sum += n.weight * (spreads_(is, key) - spreads_(was, key));
    }
    return sum;
  }

  ScreenMask& mask_;
  const KeySpreads& spreads_;
  std::vector<Near> near_;
};

}  // namespace

std::uint32_t mask_rows(std::uint32_t sets) {
  const std::uint32_t least = sets >> std::min(3, std::countr_zero(sets));
  return least * ((64 + least - 1) / least);
}

glm::dvec2 apply_symmetry(EnsembleDomain domain, std::uint32_t symmetry, glm::dvec2 p) {
  if (domain == EnsembleDomain::cylinder) {
    const double x = p.x + (symmetry >> 1) * 0.25;
    return {x - std::floor(x), (symmetry & 1) != 0 ? 1 - p.y : p.y};
  }
  if ((symmetry & 1) != 0) p.x = 1 - p.x;
  if ((symmetry & 2) != 0) p.y = 1 - p.y;
  return (symmetry & 4) != 0 ? glm::dvec2(p.y, p.x) : p;
}

ScreenMask make_screen_mask(const Ensemble& e, EnsembleDomain domain) {
  const std::size_t n = e.cells.size() / e.sets;
  if (n > kMostScreenPoints || e.sets > kMostScreenSets) {
    throw InputError(
        fmt::format("a mask for the screen is made for sets of at most {} points, and {} are asked for; take "
                    "capcon-domain",
                    kMostScreenPoints, n));
  }
  ScreenMask mask{mask_rows(e.sets), {}};
  const std::uint32_t count = kColumns * mask.rows, keys = e.sets * kSymmetries;
  for (std::uint32_t k = 0; k < count; ++k) mask.keys.push_back(static_cast<std::uint16_t>(k % keys));
  for (std::uint32_t k = count; k > 1; --k)
    std::swap(mask.keys[k - 1], mask.keys[mix64(0, kSwapStream, k) % k]);
  Annealing(mask, KeySpreads(e, domain)).run();
  return mask;
}

}  // namespace capcon
