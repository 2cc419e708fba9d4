#include "tiling/tile_report.h"

#include <algorithm>
#include <cmath>

#include "points/ccvt.h"
#include "points/fpo.h"
#include "points/measure_bounded.h"
#include "points/region_ccvt.h"

namespace capcon {
namespace {

constexpr std::uint32_t kUntiled = 1024;  // points of the comparison, about

Measures untiled_figures(const TileReportOptions& options, bool bounded, std::uint32_t sites,
                         std::uint64_t seed) {
  if (options.farthest) {
    FpoOptions fpo_options;
    fpo_options.n = sites;
    fpo_options.seed = seed;
    return measure(fpo(fpo_options));
  }
  CcvtOptions ccvt_options;
  ccvt_options.sites = sites;
  ccvt_options.capacity = options.capacity;
  ccvt_options.seed = seed;
  if (bounded) return measure_bounded(region_ccvt({Domain::kSquare, {}}, ccvt_options));
  return measure(ccvt(ccvt_options).points);
}

}  // namespace

const TilingFigures& TileReport::worst_prefix() const {
  return *std::ranges::min_element(prefixes, {}, &TilingFigures::delta_mean);
}

bool is_farthest(const TileSet& set) {
  return set.recipe.find("--method fpo") != std::string::npos;
}

TileReport examine_tiles(const TileSet& set, const TileReportOptions& options) {
  constexpr std::uint64_t kSeed = 1;
  const std::uint32_t nt = set.points_per_tile;
  const auto side = std::max(2u, std::uint32_t(std::lround(std::sqrt(double(kUntiled) / nt))));
  double steps = 0;
  const auto progress = [&] {
    ++steps;
    if (options.on_progress) options.on_progress(steps / (options.untiled_sets + nt / 8 + 8));
  };
  TileReport report;
  std::vector<Measures> untiled;
  for (std::uint32_t s = 1; s <= options.untiled_sets; ++s, progress())
    untiled.push_back(untiled_figures(options, set.bounded(), side * side * nt, s));
  report.untiled = mean_of(untiled);

  std::vector<std::pair<std::uint32_t, std::uint32_t>> shapes = {{1, 0}, {1, 1}, {2, 0},
                                                                 {2, 2}, {4, 0}, {side, 0}};
  if (set.bounded()) shapes = {{2, 0}, {3, 0}, {4, 0}, {side, 0}};
  for (const auto& [a, b] : shapes) {
    report.tilings.push_back(tiling_figures(set, a, b, nt, options.tilings, kSeed));
    progress();
  }
  for (std::uint32_t r = 1; r <= nt && !set.bounded(); r *= 2)
    report.alone.push_back(tiling_figures(set, 1, 0, r, options.tilings, kSeed));
  for (std::uint32_t r = 1; r <= nt; ++r) {
    report.prefixes.push_back(tiling_figures(set, TileReport::kSide, 0, r, options.prefix_tilings, kSeed));
    if (r % 8 == 0) progress();
  }
  report.spectrum = tiling_spectrum(set, TileReport::kSide, options.tilings, kSeed);
  report.spike = highest_spike(report.spectrum, TileReport::kSide);
  progress();
  report.energy_ratio = report.tilings.back().energy / report.untiled.energy;
  report.delta_mean_ratio = report.tilings.back().delta_mean / report.untiled.delta_mean;
  return report;
}

}  // namespace capcon
