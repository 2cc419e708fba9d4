#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sampling/tiling_parts.h"

namespace capcon {

/// What make_tiling_parts gives: from tiles/c2n16.parts, beside the shipped tile set, where that is there,
/// belongs to `set` and has this split; else made now. The same numbers either way. InputError for a broken
/// file.
TilingParts shipped_or_made_parts(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                                  std::uint32_t parts);

/// The splits that are shipped, (points of all parts, parts): 16, 32, 64, 128 and 256 points in 2, 4, 8, ...
/// parts down to those of one point.
std::vector<std::pair<std::uint32_t, std::uint32_t>> shipped_splits();

/// The bytes of tiles/c2n16.parts; the set has two colours, all tiles, and 16 points a tile.
std::string make_shipped_parts(const TileSet& set);

}  // namespace capcon
