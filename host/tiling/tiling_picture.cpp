#include "tiling/tiling_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "points/measure.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

using Colour = TilingPicture::Colour;
constexpr Colour kPaper{252, 251, 248}, kCell{205, 208, 212}, kBorder{120, 128, 138};
constexpr Colour kCorners[] = {{214, 92, 58},  {44, 120, 168},  {233, 177, 52}, {92, 148, 84},
                               {134, 90, 160}, {110, 110, 110}, {190, 70, 120}, {70, 170, 160}};
constexpr Colour kRegions[] = {{150, 60, 40}, {40, 110, 70}, {120, 80, 150}, {34, 40, 49}};

std::string hex(Colour c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

}  // namespace

TilingPicture picture_tiling(const TileSet& set, std::uint32_t width, std::uint32_t ranks, std::uint64_t seed,
                             double size) {
  const GaussianTiling tiling(width, 0);
  const std::vector<std::uint32_t> colours = random_colours(tiling, set, seed);
  const Points points = tile_points(set, tiling, colours, ranks);
  const auto place = [&](glm::dvec2 p) { return glm::dvec2(p.x * size, (1 - p.y) * size); };
  const double tile = size / width, spacing = size / std::sqrt(double(points.size()));

  TilingPicture picture{size, kPaper, {}, {}};
  const std::vector<VoronoiCell> cells = voronoi_cells(points);
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < cells[i].corners.size(); ++k)
      picture.lines.push_back({place(points[i] + cells[i].corners[k]),
                               place(points[i] + cells[i].corners[(k + 1) % cells[i].corners.size()]),
                               0.025 * spacing, kCell});
  for (std::uint32_t k = 0; k <= width; ++k) {
    picture.lines.push_back({{k * tile, 0}, {k * tile, size}, std::max(1.0, 0.04 * spacing), kBorder});
    picture.lines.push_back({{0, k * tile}, {size, k * tile}, std::max(1.0, 0.04 * spacing), kBorder});
  }
  for (std::uint32_t y = 0; y <= width; ++y)
    for (std::uint32_t x = 0; x <= width; ++x)
      picture.discs.push_back({place(glm::dvec2(x, y) / double(width)), 0.075 * tile,
                               kCorners[colours[tiling.index(x, y)] % std::size(kCorners)]});
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell)
    for (std::uint32_t r = 0; r < ranks; ++r) {
      const RegionKind kind = set.tiles[tile_of(tiling, colours, set.colours, cell)][r].kind;
      picture.discs.push_back({place(points[cell * ranks + r]), 0.13 * spacing, kRegions[int(kind)]});
    }
  return picture;
}

std::string to_svg(const TilingPicture& picture) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{0:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{0:.0f}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{1}\"/>\n",
      picture.size, hex(picture.background));
  for (const auto& line : picture.lines)
    svg += fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
        "stroke-width=\"{:.2f}\"/>\n",
        line.from.x, line.from.y, line.to.x, line.to.y, hex(line.colour), line.width);
  for (const auto& disc : picture.discs)
    svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>\n", disc.centre.x,
                       disc.centre.y, disc.radius, hex(disc.colour));
  return svg + "</svg>\n";
}

}  // namespace capcon
