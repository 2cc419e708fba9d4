#include "points/parted.h"

#include <cmath>
#include <glm/common.hpp>

#include "base/hash.h"
#include "points/voronoi.h"

namespace capcon {

namespace {

constexpr std::uint64_t kPart = 0x70617274;  // stream of random numbers

glm::dvec2 wrapped(glm::dvec2 p) {
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};
}

}  // namespace

Points parted(const Points& points) {
  if (points.size() < 2) return points;
  const double n = static_cast<double>(points.size());
  const PeriodicVoronoi diagram(points);
  PeriodicVoronoi::Scratch scratch;
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (diagram.cut(i, scratch) < 1e-12 / n) taken.push_back(i);
  }
  Points result = points;
  const double width = std::sqrt(static_cast<double>(taken.size()) / n);
  for (const std::size_t i : taken) {
    const glm::dvec2 random(uniform64(1, kPart, 2 * i), uniform64(1, kPart, 2 * i + 1));
    result[i] = wrapped(points[i] + width * (random - 0.5));
  }
  return result;
}

}  // namespace capcon
