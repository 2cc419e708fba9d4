#pragma once

#include <cstdint>
#include <vector>

#include "tiling/gaussian_tiling.h"

namespace capcon {

/// How a set of n points is cut into tiles: a^2 + b^2 tiles with the first `ranks` points each, `extra` tiles
/// one more.
struct TilingCut {
  std::uint32_t a = 1, b = 0, ranks = 1, extra = 0;
};

/// The cut with the fewest left-over points, then the one that uses most of each tile; n <= tile points: one
/// tile.
TilingCut choose_cut(std::uint32_t n, std::uint32_t tile_points);

/// How many points each cell of a tiling has: the first `ranks` of its tile, the first `extra` cells (in the
/// order of `cells`) one more. The points are numbered cell by cell in that order, by rank within.
struct CellPoints {
  std::vector<std::uint32_t> cells;  ///< every cell of the tiling once
  std::uint32_t ranks = 1, extra = 0;

  /// Points of the fullest cell, and of all together.
  std::uint32_t most() const { return ranks + (extra > 0 ? 1 : 0); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(cells.size()) * ranks + extra; }
  /// Of the cell at a place of `cells`.
  std::uint32_t points_in(std::size_t place) const { return ranks + (place < extra ? 1 : 0); }

  /// Where a point number is: the place of its cell in `cells`, and the rank.
  struct Where {
    std::uint32_t place, rank;
  };
  Where where(std::uint32_t number) const;
};

/// The cells of a cut's tiling; those with an extra point, which come first, do not lie side by side.
CellPoints cell_points(const TilingCut& cut, const GaussianTiling& tiling);

}  // namespace capcon
