#pragma once

#include <cstdint>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// Numbers the first `ranks` points of every tile by slots, so that the points of one slot lie near the same
/// place in all tiles: what is planned for the slots of a tiling then holds, nearly, whatever tiles come.
struct TileSlots {
  std::vector<std::vector<std::uint32_t>> rank;  ///< [tile][slot]; empty for tiles that the set has not
  Points place;                                  ///< [slot]: mean over the tiles, in a tile's unit square
  double deviation = 0;  ///< root mean squared distance of points to their slot's place
};

/// Pairs of slots of a tile are exchanged while that brings points nearer to their slots' mean places; the
/// best of several starts. Deterministic.
TileSlots match_slots(const TileSet& set, std::uint32_t ranks);

}  // namespace capcon
