#include "plot/tiling_panel.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>

#include "points/measure.h"
#include "points/measure_bounded.h"
#include "tiling/tiling.h"

namespace capcon::plot {
namespace {

constexpr Colour kPaper{252, 251, 248}, kCell{205, 208, 212}, kBorder{120, 128, 138}, kOutside{40, 44, 52};
constexpr Colour kCorners[] = {{214, 92, 58},  {44, 120, 168},  {233, 177, 52}, {92, 148, 84},
                               {134, 90, 160}, {110, 110, 110}, {190, 70, 120}, {70, 170, 160}};
constexpr Colour kRegions[] = {{150, 60, 40}, {40, 110, 70}, {120, 80, 150}, {34, 40, 49}};

}  // namespace

void draw_tiling(Canvas& canvas, const Box& box, const TileSet& set, const TilingPanel& panel) {
  const GaussianTiling tiling(panel.width, 0);
  const std::uint32_t ranks = panel.ranks == 0 ? set.points_per_tile : panel.ranks;
  const std::vector<std::uint32_t> colours = random_colours(tiling, set, panel.seed);
  const Points points = tile_points(set, tiling, colours, ranks);
  const auto place = [&](glm::dvec2 p) {
    return glm::dvec2(box.x + p.x * box.width, box.bottom() - p.y * box.height);
  };
  const double tile = box.width / panel.width, spacing = box.width / std::sqrt(double(points.size()));

  canvas.rectangle(box, kPaper);
  canvas.begin_clip(box);
  const Stroke thin{kCell, 0.025 * spacing};
  if (points.size() <= kCellsUpTo && set.bounded()) {
    for (const std::vector<glm::dvec2>& cell : bounded_outlines(points)) {
      std::vector<glm::dvec2> outline;
      for (const glm::dvec2& corner : cell) outline.push_back(place(corner));
      if (!outline.empty()) outline.push_back(outline[0]);
      canvas.polyline(outline, thin);
    }
  } else if (points.size() <= kCellsUpTo) {
    const std::vector<VoronoiCell> cells = voronoi_cells(points);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].corners.empty()) continue;
      glm::dvec2 low(1), high(-1);
      for (const glm::dvec2& c : cells[i].corners) low = glm::min(low, c), high = glm::max(high, c);
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {  // the copies that reach into the square
          const glm::dvec2 at = points[i] + glm::dvec2(x, y);
          if (at.x + high.x < 0 || at.y + high.y < 0 || at.x + low.x > 1 || at.y + low.y > 1) continue;
          std::vector<glm::dvec2> outline;
          for (const glm::dvec2& c : cells[i].corners) outline.push_back(place(at + c));
          outline.push_back(outline[0]);
          canvas.polyline(outline, thin);
        }
    }
  }
  const Stroke border{kBorder, std::clamp(0.04 * spacing, std::min(1.0, 0.02 * tile), 4.0)};
  for (std::uint32_t k = 0; k <= panel.width; ++k) {
    const double at = double(k) / panel.width;
    canvas.line(place({at, 0}), place({at, 1}), border);
    canvas.line(place({0, at}), place({1, at}), border);
  }
  const auto colour_of = [&](std::uint32_t colour) {
    return set.bounded() && colour + 1 == set.colours ? kOutside : kCorners[colour % std::size(kCorners)];
  };
  for (std::uint32_t y = 0; y <= panel.width; ++y)
    for (std::uint32_t x = 0; x <= panel.width; ++x)
      canvas.disc(place(glm::dvec2(x, y) / double(panel.width)), 0.075 * tile,
                  colour_of(colours[tiling.index(x, y)]));
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell)
    for (std::uint32_t r = 0; r < ranks; ++r) {
      const RegionKind kind = set.tiles[tile_of(tiling, colours, set.colours, cell)][r].kind;
      canvas.disc(place(points[cell * ranks + r]), 0.13 * spacing, kRegions[int(kind)]);
    }
  canvas.end_clip();
}

}  // namespace capcon::plot
