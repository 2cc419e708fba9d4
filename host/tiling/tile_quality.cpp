#include "tiling/tile_quality.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "points/measure.h"
#include "tiling/tiling.h"

namespace capcon {

TilingFigures tiling_figures(const TileSet& set, std::uint32_t a, std::uint32_t b, std::uint32_t ranks,
                             std::uint32_t count, std::uint64_t seed) {
  constexpr std::uint64_t kFreshStream = 0x6672657368;  // not the one that tilings to optimise on come from
  const GaussianTiling tiling(a, b);
  TilingFigures f{tiling.size(), ranks, count};
  double energy2 = 0, delta2 = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto colours = random_colours(tiling, set.colours, mix64(seed, kFreshStream, i));
    const Measures m = measure(tile_points(set, tiling, colours, ranks));
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
