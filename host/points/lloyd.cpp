#include "points/lloyd.h"

#include <glm/common.hpp>

#include "base/hash.h"
#include "points/measure.h"

namespace capcon {

namespace {

constexpr std::uint64_t kStart = 0x6c6c6f79;

glm::dvec2 wrapped(glm::dvec2 p) {
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};  // a tiny negative coordinate rounds up to 1
}

}  // namespace

Points lloyd(const LloydOptions& options) {
  Points points(options.n);
  for (std::uint64_t i = 0; i < options.n; ++i) {
    points[i] = {uniform64(options.seed, kStart, 2 * i), uniform64(options.seed, kStart, 2 * i + 1)};
  }
  for (std::uint32_t round = 0; round < options.rounds; ++round) {
    const std::vector<VoronoiCell> cells = voronoi_cells(points);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = wrapped(points[i] + cells[i].centroid);
    if (options.on_progress) options.on_progress((round + 1.0) / options.rounds);
  }
  return points;
}

}  // namespace capcon
