#pragma once

#include <cstdint>
#include <vector>

#include "points/point_set.h"
#include "tiling/tile_set.h"

namespace capcon {

/// How a tile's points are dealt to its regions: 4 corner + 4 edge_side + interior of them.
struct RegionCounts {
  std::uint32_t corner = 1;     ///< points of a corner in each of its four quadrants
  std::uint32_t edge_side = 2;  ///< points of an edge on each of its two sides
  std::uint32_t interior = 4;
};

/// The usual split: one row of points along the sides belongs to corners and edges. InputError below 9
/// points.
RegionCounts region_counts(std::uint32_t points_per_tile);

/// The free points of a tile set: each is the common position of all copies of one point of a
/// region.
struct TiedPoints {
  struct FreePoint {
    RegionKind kind = RegionKind::interior;
    std::uint32_t region = 0, part = 0, slot = 0;
    double copies_per_tile = 0;  ///< expected in a random tiling: in a complete set 1/C for a corner's, 1/C^2
                                 ///< for an edge's, 1/C^4 for a tile's
    glm::dvec2 position{0};      ///< in the unit square of the tiles that show it
  };
  std::uint32_t colours = 2, points_per_tile = 16;
  std::vector<FreePoint> free;
  std::vector<std::vector<std::uint32_t>>
      tiles;  ///< per tile number the indices of its free points; none where a compact set has no tile
  Colouring colouring = Colouring::free;
};

/// Free points at random places, apart from each other, in rectangles of the right area; deterministic by
/// seed.
TiedPoints random_tied_points(std::uint32_t colours, std::uint32_t points_per_tile, RegionCounts counts,
                              std::uint64_t seed, Colouring colouring = Colouring::free);

/// The tile set in the order of `tiles`.
TileSet to_tile_set(const TiedPoints& points, std::string recipe);

}  // namespace capcon
