#include "points/measure.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "points/discrepancy.h"
#include "points/transport.h"
#include "points/voronoi.h"

namespace capcon {

namespace {
constexpr std::size_t kBlock = 1024;  // cells a task; fixed, so that sums do not depend on the threads

/// Bond-orientational order of one cell, its edges weighted by their length: a neighbour lies across each
/// edge, in the direction of the edge's normal. The weights make it a continuous function of the points
/// (Mickel, Kapfer, Schroeder-Turk, Mecke 2013); with equal weights a square lattice has no definite value.
std::complex<double> bond_order(const std::vector<glm::dvec2>& corners) {
  std::complex<double> sum = 0;
  double perimeter = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec2 edge = corners[k + 1 < corners.size() ? k + 1 : 0] - corners[k];
    const double length = std::hypot(edge.x, edge.y);
    if (length == 0) continue;
    const std::complex<double> normal(edge.y / length, -edge.x / length);
    const std::complex<double> cube = normal * normal * normal;
    sum += length * cube * cube;
    perimeter += length;
  }
  return perimeter > 0 ? sum / perimeter : 0;
}

struct Sums {
  double nearest_min = 1, nearest = 0, second_moment = 0, area_error2 = 0, centroid2 = 0, order = 0;
  std::complex<double> common_order = 0;

  void add(const Sums& other) {
    nearest_min = std::min(nearest_min, other.nearest_min);
    nearest += other.nearest;
    second_moment += other.second_moment;
    area_error2 += other.area_error2;
    centroid2 += other.centroid2;
    order += other.order;
    common_order += other.common_order;
  }
};

}  // namespace

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
      sums.centroid2 += glm::dot(centroid, centroid);
      const std::complex<double> order = bond_order(scratch.corners);
      sums.order += std::abs(order);
      sums.common_order += order;
    }
    blocks[block] = sums;
  });
  Sums total;
  for (const Sums& sums : blocks) total.add(sums);
  const double hexagonal = std::sqrt(2 / (std::sqrt(3.0) * n));
  result.delta_min = total.nearest_min / hexagonal;
  result.delta_mean = total.nearest / n / hexagonal;
  result.energy = n * total.second_moment / kHexagonEnergy;
  result.capacity_error = total.area_error2 / n;
  result.area_sd = std::sqrt(result.capacity_error);
  result.centroid_rms = std::sqrt(total.centroid2 / n) / hexagonal;
  result.psi6 = std::abs(total.common_order) / n;
  result.psi6_local = total.order / n;
  return result;
}

Measures measure_fully(const Points& points, std::size_t limit) {
  Measures result = measure(points);
  result.l2_star = l2_star_discrepancy(points);
  if (points.size() > limit || points.empty()) return result;
  result.star = star_discrepancy(points);
  try {
    result.energy_ot = transport_energy(points);
  } catch (const Failure&) {  // points in tiny flat clusters: all else can be said of them
  }
  return result;
}

Measures mean_of(const std::vector<Measures>& all) {
  Measures mean;
  if (all.empty()) return mean;
  const bool alike = std::all_of(all.begin(), all.end(), [&](const Measures& m) { return m.n == all[0].n; });
  mean.n = alike ? all[0].n : 0;
  for (const MeasureField& field : measure_fields()) {
    double sum = 0;
    for (const Measures& m : all) sum += m.*field.value;
    mean.*field.value = sum / static_cast<double>(all.size());
  }
  return mean;
}

const std::vector<MeasureField>& measure_fields() {
  static const std::vector<MeasureField> fields = {{"delta_min", &Measures::delta_min},
                                                   {"delta_mean", &Measures::delta_mean},
                                                   {"energy", &Measures::energy},
                                                   {"energy_ot", &Measures::energy_ot},
                                                   {"area_sd", &Measures::area_sd},
                                                   {"capacity_error", &Measures::capacity_error},
                                                   {"centroid_rms", &Measures::centroid_rms},
                                                   {"psi6", &Measures::psi6},
                                                   {"psi6_local", &Measures::psi6_local},
                                                   {"star", &Measures::star},
                                                   {"l2_star", &Measures::l2_star}};
  return fields;
}

nlohmann::ordered_json to_json(const Measures& measures) {
  nlohmann::ordered_json json = {{"n", measures.n}};
  for (const MeasureField& field : measure_fields()) {
    if (const double value = measures.*field.value; std::isfinite(value)) json[field.name] = value;
  }
  return json;
}

}  // namespace capcon
