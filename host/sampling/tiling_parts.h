#pragma once

#include <cstdint>
#include <vector>

#include "sampling/tiling_cut.h"
#include "tiling/tile_set.h"

namespace capcon {

/// How the points of a tiling are dealt to parts, whatever the tiling; numbers only, so that it can be
/// shipped (parts_file.h).
///
/// Few tiles have few colourings: `rank` is empty and every colouring has an order of its own, its own
/// partition (appendix A.2); bit v of a colouring is the colour of vertex v. Else one order serves all
/// colourings, and `rank` says what point of its tile a slot stands for: where a part has as many points in
/// every tile, two or more, the tiles' points are labelled (tile_labels.h); else the places that the tiles'
/// points have nearly in common (tile_slots.h) are cut by the partition.
struct TilingParts {
  std::vector<std::vector<std::uint32_t>> rank;    ///< [tile][slot], a permutation of the ranks
  std::vector<std::vector<std::uint32_t>> orders;  ///< [colouring, or 0][i]: point number (CellPoints), part
                                                   ///< by part; slots number points where there are any

  bool operator==(const TilingParts&) const = default;
};

/// Whether every colouring of a tiling has an order of its own: at most five tiles.
bool has_whole_tilings(const GaussianTiling& tiling);

/// `parts` divides the number of points. For complete sets of two colours, and for bounded sets, whose few
/// tiles are dealt as many are. Deterministic.
TilingParts make_tiling_parts(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                              std::uint32_t parts);

/// The points of a coloured tiling on the torus, by number.
std::vector<FixedPoint> whole_tiling(const TileSet& set, const GaussianTiling& tiling,
                                     const CellPoints& points, std::uint32_t colouring);

}  // namespace capcon
