#pragma once

#include <cstdint>

#include "tiling/tile_set.h"

namespace capcon {

/// Orders the points of every tile so that the first r of all tiles are well spread in any tiling, for every
/// r. The order minimises, summed over r, the expected potential of the prefixes in an infinite random tiling
/// (exact expectations over all pairs of tiles, no sampling) and in the one-tile tilings; pairs repel each
/// other within a distance that grows with the spacing of r points a tile (void and cluster, Ulichney 1993).
/// Annealed with swaps of two ranks; deterministic by seed.
void rank_points(TileSet& set, std::uint64_t seed, std::uint32_t moves_per_point = 20000);

}  // namespace capcon
