#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// A picture of a square tiling: flat shapes in the order in which they are painted, y downwards, in pixels.
struct TilingPicture {
  using Colour = std::array<std::uint8_t, 3>;
  struct Line {
    glm::dvec2 from, to;
    double width;
    Colour colour;
  };
  struct Disc {
    glm::dvec2 centre;
    double radius;
    Colour colour;
  };
  double size = 0;  ///< width and height
  Colour background{};
  std::vector<Line> lines;
  std::vector<Disc> discs;  ///< above the lines
};

/// width x width tiles with random corner colours: Voronoi cells, tile borders, corners as discs of their
/// colour, points in the tint of their region's kind; the first `ranks` points of every tile.
TilingPicture picture_tiling(const TileSet& set, std::uint32_t width, std::uint32_t ranks, std::uint64_t seed,
                             double size = 800);

std::string to_svg(const TilingPicture& picture);

}  // namespace capcon
