#include "points/measure.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "points/voronoi.h"

namespace capcon {

namespace {
constexpr std::size_t kBlock = 1024;  // cells a task; fixed, so that sums do not depend on the threads
}

std::vector<VoronoiCell> voronoi_cells(const Points& points) {
  const PeriodicVoronoi diagram(points);
  std::vector<VoronoiCell> cells(points.size());
  parallel_for((points.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    PeriodicVoronoi::Scratch scratch;
    for (std::size_t k = block * kBlock; k < std::min(points.size(), (block + 1) * kBlock); ++k) {
      const std::uint32_t i = diagram.order()[k];
      diagram.cut(i, scratch);
      cells[i].corners = scratch.corners;
      integrate_polygon(scratch.corners, cells[i].area, cells[i].centroid, cells[i].second_moment);
    }
  });
  return cells;
}

Measures measure(const Points& points) {
  Measures result;
  result.n = points.size();
  if (points.empty()) return result;
  struct Sums {
    double nearest_min = 1, nearest = 0, second_moment = 0, area_error2 = 0;
  };
  const PeriodicVoronoi diagram(points);
  const double n = static_cast<double>(points.size());
  std::vector<Sums> blocks((points.size() + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), [&](std::size_t block) {
    PeriodicVoronoi::Scratch scratch;
    Sums sums;
    for (std::size_t k = block * kBlock; k < std::min(points.size(), (block + 1) * kBlock); ++k) {
      const double distance = std::sqrt(diagram.cut(diagram.order()[k], scratch));
      double area, second_moment;
      glm::dvec2 centroid;
      integrate_polygon(scratch.corners, area, centroid, second_moment);
      sums.nearest_min = std::min(sums.nearest_min, distance);
      sums.nearest += distance;
      sums.second_moment += second_moment;
      sums.area_error2 += (n * area - 1) * (n * area - 1);
    }
    blocks[block] = sums;
  });
  Sums total;
  for (const Sums& sums : blocks) {
    total.nearest_min = std::min(total.nearest_min, sums.nearest_min);
    total.nearest += sums.nearest;
    total.second_moment += sums.second_moment;
    total.area_error2 += sums.area_error2;
  }
  const double hexagonal = std::sqrt(2 / (std::sqrt(3.0) * n));
  result.delta_min = total.nearest_min / hexagonal;
  result.delta_mean = total.nearest / n / hexagonal;
  result.energy = n * total.second_moment / kHexagonEnergy;
  result.area_sd = std::sqrt(total.area_error2 / n);
  return result;
}

nlohmann::json to_json(const Measures& measures) {
  return {{"n", measures.n},
          {"delta_min", measures.delta_min},
          {"delta_mean", measures.delta_mean},
          {"energy", measures.energy},
          {"area_sd", measures.area_sd}};
}

}  // namespace capcon
