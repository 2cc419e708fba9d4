#include "tiling/tile_quality.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "points/measure.h"
#include "points/measure_bounded.h"

namespace capcon {

Points fresh_tiling(const TileSet& set, const GaussianTiling& tiling, std::uint32_t ranks, std::uint32_t i,
                    std::uint64_t seed) {
  constexpr std::uint64_t kFreshStream = 0x6672657368;
  return tile_points(set, tiling, random_colours(tiling, set, mix64(seed, kFreshStream, i)), ranks);
}

TilingFigures tiling_figures(const TileSet& set, std::uint32_t a, std::uint32_t b, std::uint32_t ranks,
                             std::uint32_t count, std::uint64_t seed) {
  const GaussianTiling tiling(a, b);
  TilingFigures f{tiling.size(), ranks, count};
  double energy2 = 0, delta2 = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Points points = fresh_tiling(set, tiling, ranks, i, seed);
    const Measures m = set.bounded() ? measure_bounded(points) : measure(points);
    f.energy += m.energy / count;
    f.delta_mean += m.delta_mean / count;
    f.delta_min += m.delta_min / count;
    energy2 += m.energy * m.energy / count;
    delta2 += m.delta_mean * m.delta_mean / count;
  }
  f.energy_sd = std::sqrt(std::max(0.0, energy2 - f.energy * f.energy));
  f.delta_mean_sd = std::sqrt(std::max(0.0, delta2 - f.delta_mean * f.delta_mean));
  return f;
}

nlohmann::ordered_json to_json(const TilingFigures& f) {
  return {{"tiles", f.tiles},
          {"ranks", f.ranks},
          {"tilings", f.tilings},
          {"energy", f.energy},
          {"energy_sd", f.energy_sd},
          {"delta_mean", f.delta_mean},
          {"delta_mean_sd", f.delta_mean_sd},
          {"delta_min", f.delta_min}};
}

}  // namespace capcon
