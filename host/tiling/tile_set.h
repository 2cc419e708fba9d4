#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "points/point_set.h"
#include "tiling/colouring.h"
#include "tiling/fixed_point.h"

namespace capcon {

/// The kind of region of a tile that a point belongs to; copies of a corner or an edge region hold the same
/// points.
enum class RegionKind : std::uint8_t { corner, horizontal_edge, vertical_edge, interior };

/// "corner", "horizontal", "vertical", "interior": the words of the file format.
std::string_view region_name(RegionKind kind);

/// A set of corner tiles: tile number = colours of its corners (0,0), (1,0), (0,1), (1,1) read as a number in
/// base `colours`, the first the lowest digit. A complete set has all colours^4 tiles, a compact one those
/// whose sides its colouring allows, a bounded one those that tilings of a square with a border need; the
/// last of its colours is outside.
struct TileSet {
  std::uint32_t colours = 2;
  std::uint32_t points_per_tile = 16;
  std::string recipe;  ///< the command that makes this set

  struct TilePoint {
    FixedPoint position;  ///< in the tile's own unit square
    RegionKind kind = RegionKind::interior;
    std::uint32_t region =
        0;  ///< corner: its colour; edge: c0 + colours * c1 along +x or +y; interior: the tile
    std::uint32_t slot = 0;  ///< which point of that region
  };
  /// tiles[t][r]: the point of rank r of tile number t. Any prefix of all tiles is well spread in any tiling.
  /// colours^4 entries, those of tiles that a compact or bounded set does without are empty.
  std::vector<std::vector<TilePoint>> tiles;
  Colouring colouring = Colouring::free;

  bool bounded() const { return colouring == Colouring::bounded; }
  /// How many tiles there are.
  std::size_t tile_count() const {
    return std::size_t(std::ranges::count_if(tiles, [](const auto& t) { return !t.empty(); }));
  }
};

/// Reads a capcon-tiles file (docs/tile-format.md). InputError with file:line for a wrong magic, version,
/// checksum, truncated or inconsistent content.
TileSet read_tile_set(const std::filesystem::path& path);
void write_tile_set(const std::filesystem::path& path, const TileSet& set);

/// The same from and to text; `name` stands in messages.
TileSet parse_tile_set(std::string_view text, const std::string& name);
std::string format_tile_set(const TileSet& set);

/// The checksum that stands in the set's file.
std::uint64_t checksum(const TileSet& set);

/// The shipped set tiles/c<colours>n<points>.tiles.
TileSet shipped_tile_set(std::uint32_t colours = 2, std::uint32_t points_per_tile = 16);
/// The shipped set tiles/<name>.tiles: c2n16, c2n64, c3n16-compact, c2n16-bounded.
TileSet shipped_tile_set(const std::string& name);

}  // namespace capcon
