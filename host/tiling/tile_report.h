#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "points/measure.h"
#include "tiling/tile_quality.h"
#include "tiling/tile_spectrum.h"

namespace capcon {

/// How much is measured of a tile set, and what with it is compared.
struct TileReportOptions {
  std::uint32_t tilings = 20;                    ///< random tilings of each size, of the spectrum too
  std::uint32_t prefix_tilings = 5;              ///< of each length of prefixes
  std::uint32_t untiled_sets = 2;                ///< points made without tiles
  std::uint32_t capacity = 1024;                 ///< of these, where they are capacity-constrained
  bool farthest = false;                         ///< compare with farthest-point sets
  std::function<void(double done)> on_progress;  ///< in [0, 1]; may be empty
};

/// What a tile set is worth, all of it on tilings that it was not optimised on.
struct TileReport {
  static constexpr double kTolerance = 0.03;  ///< part by which tilings may be worse than untiled points
  static constexpr double kSpike = 3;         ///< largest allowed ratio of a spike to its surroundings
  static constexpr double kPrefix = 0.70;     ///< least delta_mean of every prefix
  static constexpr std::uint32_t kSide = 8;   ///< tiles along a side, for prefixes and spectrum

  std::vector<TilingFigures> tilings;   ///< 1, 2, 4, 8, 16 tiles (bounded: 4, 9, 16) and at last about 1024
                                        ///< points
  std::vector<TilingFigures> alone;     ///< the first 1, 2, 4, ... points of one-tile tilings; bounded: none
  std::vector<TilingFigures> prefixes;  ///< [r - 1]: the first r points of every tile of kSide x kSide
  Measures untiled;                     ///< means of sets as large as the last tilings
  double energy_ratio = 0, delta_mean_ratio = 0;  ///< of the last tilings to these
  Spectrum spectrum;                              ///< of kSide x kSide tilings
  Spike spike;

  const TilingFigures& worst_prefix() const;
  bool as_good_as_untiled() const {
    return energy_ratio <= 1 + kTolerance && delta_mean_ratio >= 1 - kTolerance;
  }
  bool without_spikes() const { return spike.ratio() <= kSpike; }
  bool well_ranked() const { return worst_prefix().delta_mean >= kPrefix; }
};

/// InputError for sets whose tilings would be of no size that can be measured (none is known).
TileReport examine_tiles(const TileSet& set, const TileReportOptions& options);

/// Whether the recipe says --method fpo.
bool is_farthest(const TileSet& set);

}  // namespace capcon
