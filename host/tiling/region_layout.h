#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// colours^4, the size of a complete set and the number of tile numbers.
std::uint32_t tile_count(std::uint32_t colours);
/// Colours of a tile's corners (0,0), (1,0), (0,1), (1,1).
std::array<std::uint32_t, 4> tile_colours(std::uint32_t colours, std::uint32_t tile);

/// Where in a tile a region's part lies: `part` of a corner region is the tile's corner 0 to 3 that it sits
/// at, of a horizontal edge 0 (the tile's bottom side) or 1 (its top), of a vertical edge 0 (left) or 1
/// (right), else 0. A point of a region's part can thus never leave its tile, whatever the tiling.
std::uint32_t part_count(RegionKind kind);
/// The region of this kind that a tile shows at this part.
std::uint32_t tile_region(std::uint32_t colours, std::uint32_t tile, RegionKind kind, std::uint32_t part);

/// The first violation of "all copies of a region hold the same points, and every tile holds all points of
/// its regions"; also two equal points in a tile.
struct RegionFault {
  bool operator==(const RegionFault&) const = default;
  std::size_t tile = 0, rank = 0;
  std::string message;
};
std::optional<RegionFault> find_region_fault(const TileSet& set);

}  // namespace capcon
