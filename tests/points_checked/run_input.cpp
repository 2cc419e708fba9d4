#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "base/hash.h"
#include "points/ccvt.h"
#include "points/ccvt_exchange.h"
#include "points/ccvt_optimise.h"
#include "points/cell_swaps.h"
#include "points/checks.h"
#include "points/ensemble.h"
#include "points/ensemble_start.h"
#include "points/fpo.h"
#include "points/lloyd.h"
#include "points/measure.h"
#include "points/near_swaps.h"
#include "points/region_ccvt.h"
#include "points/spectrum.h"
#include "points/spread_partition.h"
#include "points/transport.h"
#include "points/transport_finish.h"
#include "points_checked/random_input.h"

namespace capcon {
namespace {

using Task = RandomInput::Task;

void inside(const Points& points, std::size_t count, Domain domain) {
  require(points.size() == count, fmt::format("{} points instead of {}", points.size(), count));
  for (const glm::dvec2& p : points) {
    require(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1, fmt::format("a point at ({}, {})", p.x, p.y));
    require(domain != Domain::kDisk || std::hypot(p.x - 0.5, p.y - 0.5) <= 0.5 + 1e-9,
            "a point outside the disk");
  }
}

/// Space points in any places, dealt to the sites anyhow.
void run_cells(const RandomInput& in) {
  std::vector<TorusPoint> points;
  for (const glm::dvec2& p : in.places(in.n * in.capacity))
    points.push_back({static_cast<std::uint32_t>(p.x * 0x1p32), static_cast<std::uint32_t>(p.y * 0x1p32)});
  for (std::size_t k = points.size(); k > 1 && in.u(500) < 0.7; --k)
    std::swap(points[k - 1], points[mix64(in.number, 1, k) % k]);
  CcvtCells cells(in.capacity, points);
  const bool leads = in.u(501) < 0.2;
  CcvtPace pace;
  if (leads) pace.lead = 1.8, pace.most_passes = 10;
  optimise(cells, pace);
  if (leads) optimise(cells);
  require(cells.size() == in.n && std::isfinite(cells.energy()), "ccvt: no energy");
  CcvtScratch scratch;
  for (std::size_t i = 0; i < in.n; ++i) {
    for (std::size_t j = i + 1; j < in.n; ++j)
      require(exchange(cells, i, j, scratch) == 0, "ccvt: ended although an exchange gains");
  }
}

void run_ccvt(const RandomInput& in) {
  CcvtOptions options;
  options.sites = in.n;
  options.capacity = in.capacity;
  options.seed = in.number;
  const CcvtResult result = ccvt(options);
  inside(result.points, in.n, Domain::kTorus);
  require(result.capacity == in.capacity && result.energy >= 0 && std::isfinite(result.energy),
          "ccvt: no energy");
}

void run_region(const RandomInput& in) {
  CcvtOptions options;
  options.sites = in.n;
  options.capacity = in.capacity;
  options.seed = in.number;
  const Region region = in.region();
  const RegionCells cells = region_ccvt_cells(region, options);
  inside(cells.sites, in.n, in.domain);
  inside(cells.space_points, std::size_t(in.n) * in.capacity, in.domain);
  if (!region.density) return;
  const auto [low, high] = region.density->support();
  for (const glm::dvec2& p : cells.space_points)
    require(glm::all(glm::greaterThanEqual(p, low - 1e-9)) && glm::all(glm::lessThanEqual(p, high + 1e-9)),
            "a space point where there is no mass");
}

/// Each name once, in sets of n.
void check_sets(const Ensemble& e, std::uint32_t n) {
  std::vector<std::uint32_t> names = e.cells;
  std::sort(names.begin(), names.end());
  require(names.size() == std::size_t(n) * e.sets, "an ensemble of another size");
  for (std::uint32_t k = 0; k < names.size(); ++k)
    require(names[k] == k, "an ensemble's cell twice, or never");
}

void run_cell_swaps(const RandomInput& in) {
  const Points places = in.places(2 * in.n);
  std::vector<glm::vec3> centres;
  for (const glm::dvec2& p : places)
    centres.emplace_back(in_space(static_cast<EnsembleDomain>(in.domain), p));
  Ensemble e{2 * in.n, 1, 2, {}};
  for (std::uint32_t i = 0; i < 2 * in.n; ++i) e.cells.push_back(i);
  swap_cells(static_cast<EnsembleDomain>(in.domain), centres, e.cells.data(), e.cells.data() + in.n, in.n);
  check_sets(e, in.n);
}

void run_near_swaps(const RandomInput& in) {
  Ensemble e = start_ensemble(in.n, 3, in.number);
  std::vector<glm::vec3> centres(e.cells.size());
  const Points places = in.places(static_cast<std::uint32_t>(e.cells.size()));
  for (std::uint32_t c = 0; c < e.cells.size(); ++c) {
    const glm::dvec2 even((c % e.columns + 0.5) / e.columns, (c / e.columns + 0.5) / e.rows);
    centres[c] = in_space(static_cast<EnsembleDomain>(in.domain), in.u(502) < 0.7 ? even : places[c]);
  }
  swap_near(e, static_cast<EnsembleDomain>(in.domain), centres, 4, in.number);
  check_sets(e, in.n);
}

void run_partition(const RandomInput& in) {
  const auto subsets = static_cast<std::uint32_t>(1 + in.u(503) * in.n);
  const auto labels = in.u(504) < 0.8 ? partition(in.places(in.n), {subsets, in.number})
                                      : spread_partition(in.places(in.n), {subsets, in.number});
  std::vector<std::uint32_t> sizes(subsets);
  for (const std::uint32_t label : labels) ++sizes.at(label);
  require(
      labels.size() == in.n &&
          *std::max_element(sizes.begin(), sizes.end()) - *std::min_element(sizes.begin(), sizes.end()) <= 1,
      "partition: subsets of uneven sizes");
}

void run_transport(const RandomInput& in) {
  FinishOptions options;
  options.most_rounds = 25;
  options.square = in.domain == Domain::kSquare;
  const FinishResult result = transport_finish(in.places(in.n), options);
  inside(result.points, in.n, Domain::kTorus);
  require(result.area_error <= 1e-10 && std::isfinite(result.energy) && result.energy > 0,
          "finish: uneven cells");
}

void run_fpo(const RandomInput& in) {
  FpoOptions options;
  options.n = in.n;
  options.seed = in.number;
  options.strategy = in.capacity % 2 == 0 ? FpoOptions::Strategy::kGlobal : FpoOptions::Strategy::kLocal;
  inside(in.u(505) < 0.3 ? fpo(options) : fpo_from(in.places(in.n), options), in.n, Domain::kTorus);
}

void run_lloyd(const RandomInput& in) {
  inside(lloyd({in.n, in.number, 6, in.region()}), in.n, in.domain);
}

void run_measure(const RandomInput& in) {
  const Points points = in.places(in.n);
  const Measures measures = measure_fully(points);
  for (const MeasureField& field : measure_fields()) {
    const double value = measures.*field.value;
    require(value >= 0 && std::isfinite(value), fmt::format("{} is {}", field.name, value));
  }
  require(measures.star <= 1 && measures.psi6 <= 1 + 1e-12, "a measure beyond its range");
  double area = 0;
  for (const VoronoiCell& cell : voronoi_cells(points)) {
    require(cell.area >= 0, "a cell of negative area");
    area += cell.area;
  }
  require(std::abs(area - 1) < 1e-9, fmt::format("voronoi cells of area {}", area));
  const Spectrum spectrum = power_spectrum({points}, default_reach(in.n));
  for (const double power : spectrum.power)
    require(power >= 0 && power <= 1.001 * in.n, "a power out of range");
  std::vector<double> weights(in.n);
  for (std::uint32_t i = 0; i < in.n; ++i) weights[i] = 0.1 / in.n * in.u(600 + i);
  PowerDiagram diagram;
  diagram.compute(points, weights, nullptr, 0);
  area = 0;
  for (std::size_t i = 0; i < in.n; ++i) area += diagram.moments(i).area;
  // Sites in one place are told apart by their weights alone, the heaviest has it all.
  require(std::abs(area - 1) < 1e-9, fmt::format("power cells of area {}", area));
}

}  // namespace

void run_input(const RandomInput& in) {
  switch (in.task) {
    case Task::kCells:
      return run_cells(in);
    case Task::kCcvt:
      return run_ccvt(in);
    case Task::kRegion:
      return run_region(in);
    case Task::kCellSwaps:
      return run_cell_swaps(in);
    case Task::kNearSwaps:
      return run_near_swaps(in);
    case Task::kPartition:
      return run_partition(in);
    case Task::kTransport:
      return run_transport(in);
    case Task::kFpo:
      return run_fpo(in);
    case Task::kLloyd:
      return run_lloyd(in);
    case Task::kMeasure:
      return run_measure(in);
  }
}

}  // namespace capcon
