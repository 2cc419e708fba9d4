#include "points/region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "points/lattice.h"
#include "points/sobol.h"

namespace capcon {

namespace {

enum Stream : std::uint64_t { kRandom = 1, kShift = 0x7265676e, kMirror, kSobolX, kSobolY };

/// The points u(0), u(1) ... of the square, warped, that fall into the disk, until there are m.
template <class Sequence>
Points rejected(const Density& density, std::uint64_t m, const Sequence& u) {
  const Density near_disk = density.about_disk();
  Points points;
  points.reserve(m);
  for (std::uint64_t i = 0; points.size() < m; ++i) {
    // At worst a single texel matters, the corner of which is in the disk.
    if (i > 1000 * (m + 1000))
      throw InputError("too little of the density is in the disk; give a finer image");
    const glm::dvec2 p = near_disk.warp(u(i));
    if (is_in_disk(p)) points.push_back(p);
  }
  return points;
}

}  // namespace

glm::dvec2 to_disk(glm::dvec2 u) {
  const double a = 2 * u.x - 1, b = 2 * u.y - 1;
  if (a == 0 && b == 0) return {0.5, 0.5};
  const bool wide = std::abs(a) > std::abs(b);
  const double radius = 0.5 * (wide ? a : b);
  const double angle =
      wide ? std::numbers::pi / 4 * (b / a) : std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
  constexpr double kBelowOne = 1 - 0x1p-53;
  return {std::min(0.5 + radius * std::cos(angle), kBelowOne),
          std::min(0.5 + radius * std::sin(angle), kBelowOne)};
}

bool is_in_disk(glm::dvec2 p) {
  return (p.x - 0.5) * (p.x - 0.5) + (p.y - 0.5) * (p.y - 0.5) <= 0.25;
}

glm::dvec2 place(const Region& region, glm::dvec2 u) {
  if (region.domain != Domain::kDisk) return region.density ? region.density->warp(u) : u;
  if (region.density)
    throw InputError("this method cannot have a density on the disk; use ccvt, lloyd or random");
  return to_disk(u);
}

void place_all(const Region& region, Points& points) {
  for (glm::dvec2& p : points) p = place(region, p);
}

Points spread(const Region& region, std::uint64_t m, std::uint64_t seed) {
  if (region.domain == Domain::kDisk && region.density) {
    return rejected(*region.density, m, [seed](std::uint64_t i) {
      const auto index = static_cast<std::uint32_t>(i);
      return glm::dvec2(owen_scrambled(sobol_x(index), seed, kSobolX),
                        owen_scrambled(sobol_y(index), seed, kSobolY)) *
             0x1p-32;
    });
  }
  const std::uint64_t shift = mix64(seed, kShift, m), mirror = mix64(seed, kMirror, m);
  Points points;
  points.reserve(m);
  for (TorusPoint p : points_of(even_lattice(m))) {
    if (mirror & 1) p.x = 0 - p.x;
    if (mirror & 2) std::swap(p.x, p.y);
    p.x += static_cast<std::uint32_t>(shift >> 32);
    p.y += static_cast<std::uint32_t>(shift);
    points.push_back(place(region, glm::dvec2(p.x, p.y) * 0x1p-32));
  }
  return points;
}

Points random_points(const Region& region, std::uint32_t n, std::uint64_t seed) {
  const auto u = [seed](std::uint64_t i) {
    return glm::dvec2(uniform64(seed, kRandom, 2 * i), uniform64(seed, kRandom, 2 * i + 1));
  };
  if (region.domain == Domain::kDisk && region.density) return rejected(*region.density, n, u);
  Points points(n);
  for (std::uint32_t i = 0; i < n; ++i) points[i] = place(region, u(i));
  return points;
}

}  // namespace capcon
