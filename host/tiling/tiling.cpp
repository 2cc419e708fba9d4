#include "tiling/tiling.h"

namespace capcon {

std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                          std::uint64_t seed) {
  return random_colours(tiling, colours, Colouring::free, seed);
}

std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, const TileSet& set,
                                          std::uint64_t seed) {
  return random_colours(tiling, set.colours, set.colouring, seed);
}

std::uint32_t tile_of(const GaussianTiling& tiling, const std::vector<std::uint32_t>& colours,
                      std::uint32_t colour_count, std::uint32_t cell) {
  std::uint32_t tile = 0, digit = 1;
  for (const std::uint32_t vertex : tiling.corners(cell)) {
    tile += colours[vertex] * digit;
    digit *= colour_count;
  }
  return tile;
}

Points tile_points(const TileSet& set, const GaussianTiling& tiling,
                   const std::vector<std::uint32_t>& colours, std::uint32_t ranks) {
  Points points;
  points.reserve(std::size_t(tiling.size()) * ranks);
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
    const FixedPoint origin = tiling.origin(cell);
    const auto& tile = set.tiles.at(tile_of(tiling, colours, set.colours, cell));
    for (std::uint32_t r = 0; r < ranks; ++r) {
      const FixedPoint placed = tiling.place(tile.at(r).position);
      points.push_back(to_double({origin.x + placed.x, origin.y + placed.y}));
    }
  }
  return points;
}

}  // namespace capcon
