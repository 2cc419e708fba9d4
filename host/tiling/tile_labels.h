#pragma once

#include <cstdint>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// Labels of every tile's points, so that in any tiling the points of one label, all cells together, are well
/// spread: trajectory splitting into `parts` subsets, whatever the tiling. labels[tile][rank] in [0, parts),
/// each as often in every tile; empty for tiles that the set has not.
using TileLabels = std::vector<std::vector<std::uint32_t>>;

/// `parts` divides the points of a tile. Pairs of one label repel each other within a distance that grows
/// with the spacing of a part's points, with exact chances for all pairs of tiles in an infinite random
/// tiling (as ranks do, tile_ranking.h). Annealed by swaps of two labels of a tile, in 0.05 s for 16 tiles of
/// 16 points; deterministic by seed.
TileLabels label_parts(const TileSet& set, std::uint32_t parts, std::uint64_t seed = 1,
                       std::uint32_t moves_per_point = 5000);

}  // namespace capcon
