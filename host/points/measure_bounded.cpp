#include "points/measure_bounded.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "points/mirrors.h"

namespace capcon {

Measures measure_bounded(const Points& points) {
  // What is counted in shares of the points is the same for a quarter of the torus and all of it.
  Measures m = measure(mirrored(points));
  m.n = points.size();
  m.delta_min = m.delta_mean = 0;
  if (points.size() < 2) return m;
  const auto n = double(points.size());
  const double hexagonal = std::sqrt(2 / (std::sqrt(3.0) * n));
  double least = 2;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest2 = 2;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec2 d = points[k] - points[i];
      if (k != i) nearest2 = std::min(nearest2, glm::dot(d, d));
    }
    m.delta_mean += std::sqrt(nearest2) / (n * hexagonal);
    least = std::min(least, nearest2);
  }
  m.delta_min = std::sqrt(least) / hexagonal;
  return m;
}

std::vector<std::vector<glm::dvec2>> bounded_outlines(const Points& points) {
  const Points all = mirrored(points);
  const std::vector<VoronoiCell> cells = voronoi_cells(all);
  std::vector<std::vector<glm::dvec2>> outlines(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const glm::dvec2& corner : cells[i].corners) outlines[i].push_back(2.0 * (all[i] + corner));
  return outlines;
}

}  // namespace capcon
