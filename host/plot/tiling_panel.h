#pragma once

#include <cstdint>

#include "plot/canvas.h"
#include "tiling/tile_set.h"

namespace capcon::plot {

/// What of a tiling is drawn.
struct TilingPanel {
  std::uint32_t width = 4;  ///< tiles along a side
  std::uint32_t ranks = 0;  ///< only the first points of every tile; 0 = all
  std::uint64_t seed = 1;   ///< of the corner colours
};

/// A square tiling with random corner colours in a square box: Voronoi cells (up to kCellsUpTo points), tile
/// borders, corners as discs of their colour (dark outside), points in the tint of their region's kind.
void draw_tiling(Canvas& canvas, const Box& box, const TileSet& set, const TilingPanel& panel);

inline constexpr std::size_t kCellsUpTo = 5000;

}  // namespace capcon::plot
