#pragma once

#include <cstdint>
#include <vector>

#include "tiling/gaussian_tiling.h"
#include "tiling/tile_set.h"

namespace capcon {

/// How many points each cell of a tiling has: the first `ranks` of its tile, the first `extra` cells (in the
/// order of `cells`) one more.
struct CellPoints {
  std::vector<std::uint32_t> cells;  ///< every cell of the tiling once
  std::uint32_t ranks = 1, extra = 0;
  std::uint32_t most() const { return ranks + (extra > 0 ? 1 : 0); }
};

/// The parts of the tilings of a torus, where few tiles have few colourings: every colouring's own partition
/// (appendix A.2). places[colouring * n + i] is point i on the torus, part by part, in Morton order within;
/// bit v of the colouring is the colour of vertex v.
std::vector<FixedPoint> parts_of_whole_tilings(const TileSet& set, const GaussianTiling& tiling,
                                               const CellPoints& points, std::uint32_t parts);

/// The parts of any tiling of a torus with many tiles. Where a part has as many points in every tile, two or
/// more, the tiles' points are labelled (tile_labels.h); else the places that the tiles' points have nearly
/// in common (tile_slots.h) are cut by the partition.
struct DealtCells {
  std::vector<std::vector<std::uint32_t>> rank;  ///< [tile][slot]: what point of the tile a slot stands for
  std::vector<std::uint32_t> order;  ///< [i]: place in CellPoints::cells | slot << 16, part by part
};
DealtCells deal_cells(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                      std::uint32_t parts);

}  // namespace capcon
