#include "points/pmj02.h"

#include <algorithm>

#include "base/hash.h"

namespace capcon {
namespace {

constexpr std::uint64_t kPlaceStream = 0x706a3032;  // where a point lies in its stratum
constexpr std::uint64_t kSwapStream = 0x73776170;   // by which axis points step aside first

/// The upper `bits` of a word.
std::uint32_t top(std::uint32_t word, std::uint32_t bits) {
  return bits == 0 ? 0 : word >> (32 - bits);
}

/// A new point: the old one whose quadrant it shares, and how many digits it takes over from it.
struct Newcomer {
  std::uint32_t partner;
  glm::uvec2 kept;
};

/// The newcomers of the step from 2^(m-1) to 2^m points.
std::vector<Newcomer> newcomers(std::uint32_t m, std::uint64_t seed) {
  const std::uint32_t k = (m - 1) / 2, quadrants = 1u << (2 * k), count = 1u << (m - 1);
  const std::uint32_t first_axis = mix64(seed, kSwapStream, m) & 1;
  std::vector<Newcomer> result(count);
  for (std::uint32_t s = 0; s < count; ++s) {
    result[s] = {s % quadrants, {k, k}};
    // Two of a quadrant's four cells are taken, across from each other: beside its first point, by one axis
    // and then by the other. The axis that does not change keeps a digit more.
    if (m % 2 == 0) result[s].kept[s < quadrants ? 1 - first_axis : first_axis] = k + 1;
  }
  return result;
}

/// Adds a coordinate's digits that follow from the points there are. Digit j: the interval of j - 1 digits by
/// m - j digits has area 2 / 2^m and so one old point; the new one takes the half across from it.
void fill_digits(std::vector<glm::uvec2>& points, const std::vector<Newcomer>& added, std::uint32_t m,
                 int axis) {
  const std::uint32_t old = 1u << (m - 1);
  const auto interval = [&](std::uint32_t coordinate, std::uint32_t other, std::uint32_t j) {
    return top(coordinate, j - 1) << (m - j) | top(other, m - j);
  };
  std::vector<std::uint8_t> digit(old);  // of the old point in each interval
  for (std::uint32_t j = (m - 1) / 2 + 1; j <= m; ++j) {
    for (std::uint32_t i = 0; i < old; ++i)
      digit[interval(points[i][axis], points[i][1 - axis], j)] = points[i][axis] >> (32 - j) & 1;
    for (std::uint32_t s = 0; s < old; ++s) {
      if (j <= added[s].kept[axis]) continue;
      std::uint32_t& coordinate = points[old + s][axis];
      // The other coordinate's digits are needed only as far as they are the partner's.
      const std::uint32_t other = points[added[s].partner][1 - axis];
      coordinate |= (digit[interval(coordinate, other, j)] ^ 1u) << (32 - j);
    }
  }
}

}  // namespace

std::vector<glm::uvec2> pmj02_sequence(std::uint32_t count, std::uint64_t seed) {
  const auto random = [&](std::uint32_t i) {
    const std::uint64_t word = mix64(seed, kPlaceStream, i);
    return glm::uvec2(static_cast<std::uint32_t>(word >> 32), static_cast<std::uint32_t>(word));
  };
  std::vector<glm::uvec2> points{random(0)};
  for (std::uint32_t m = 1; points.size() < count; ++m) {
    const std::vector<Newcomer> added = newcomers(m, seed);
    for (const Newcomer& n : added) {
      const glm::uvec2 partner = points[n.partner];
      glm::uvec2 kept(0);
      for (int axis = 0; axis < 2; ++axis) {
        if (n.kept[axis] > 0) kept[axis] = partner[axis] & ~(0xffffffffu >> n.kept[axis]);
      }
      points.push_back(kept);
    }
    fill_digits(points, added, m, 0);
    fill_digits(points, added, m, 1);
    const auto old = static_cast<std::uint32_t>(points.size() / 2);
    for (std::uint32_t i = old; i < 2 * old; ++i) points[i] |= random(i) >> m;
  }
  points.resize(std::max(count, 1u));
  return points;
}

}  // namespace capcon
