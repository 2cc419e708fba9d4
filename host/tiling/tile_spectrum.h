#pragma once

#include <cstdint>

#include "points/spectrum.h"
#include "tiling/tile_set.h"

namespace capcon {

/// The mean periodogram of `count` random side x side tilings, up to twice the frequency of the points'
/// square lattice. What repeats in every tile shows at multiples of `side`, the tile frequency.
Spectrum tiling_spectrum(const TileSet& set, std::uint32_t side, std::uint32_t count, std::uint64_t seed);

/// A multiple of the tile frequency.
struct Spike {
  int kx = 0, ky = 0;
  double power = 0;   ///< there
  double around = 0;  ///< the local mean: over the frequencies up to (side - 1) / 2 from it in x and in y
  double ratio() const { return power / around; }
};

/// The multiple of `side` (>= 3) with 0 < |k| <= reach that stands out most: largest ratio.
Spike highest_spike(const Spectrum& spectrum, std::uint32_t side);

}  // namespace capcon
