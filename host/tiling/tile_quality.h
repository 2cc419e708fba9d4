#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "points/point_set.h"
#include "tiling/tiling.h"

namespace capcon {

/// Mean and standard deviation over some tilings of what `measure` says of their points, or `measure_bounded`
/// of a bounded set's.
struct TilingFigures {
  std::uint32_t tiles = 0, ranks = 0, tilings = 0;
  double energy = 0, energy_sd = 0;
  double delta_mean = 0, delta_mean_sd = 0;
  double delta_min = 0;  ///< mean over the tilings
};

/// The i-th random tiling that sets are measured on: none of those that they are optimised on.
Points fresh_tiling(const TileSet& set, const GaussianTiling& tiling, std::uint32_t ranks, std::uint32_t i,
                    std::uint64_t seed);

/// Of `count` random tilings of a^2 + b^2 tiles (bounded: b = 0, a >= 2), each with the first `ranks` points
/// of every tile.
TilingFigures tiling_figures(const TileSet& set, std::uint32_t a, std::uint32_t b, std::uint32_t ranks,
                             std::uint32_t count, std::uint64_t seed);
nlohmann::ordered_json to_json(const TilingFigures& figures);

}  // namespace capcon
