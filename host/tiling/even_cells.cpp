#include "tiling/even_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "tiling/region_layout.h"

namespace capcon {
namespace {

/// columns x rows = count, columns : rows as near to `aspect` as divisors allow.
glm::uvec2 near_grid(std::uint32_t count, double aspect) {
  glm::uvec2 best(1, count);
  const auto far = [&](glm::uvec2 g) { return std::abs(std::log(g.x / (aspect * g.y))); };
  for (std::uint32_t columns = 1; columns <= count; ++columns)
    if (count % columns == 0 && far({columns, count / columns}) < far(best) - 1e-9)
      best = {columns, count / columns};
  return best;
}

}  // namespace

EvenCells::EvenCells(std::uint32_t colours, std::uint32_t points_per_tile) : colours_(colours) {
  const std::uint32_t inside = colours - 1, n = points_per_tile;
  const std::uint32_t points[] = {inside * inside * inside * inside * n, 4 * inside * inside * n,
                                  4 * inside * n};
  const glm::dvec2 domain[] = {{0.5, 0.5}, {0.5, 1}, {1, 1}};
  for (int c = 0; c < 3; ++c) {
    const glm::uvec2 g = near_grid(points[c], domain[c].x / domain[c].y);
    grid_[c] = {g.x, g.y, points[c], domain[c] / glm::dvec2(g), false};
  }
  const auto side = std::uint32_t(std::lround(std::sqrt(2.0 * points[2])));
  if (side * side == 2 * points[2] && side % 2 == 0)
    grid_[2] = {side, side, points[2], glm::dvec2(1.0 / side), true};
}

int EvenCells::class_of(std::uint32_t tile) const {
  return outside_sides(tile_colours(colours_, tile), colours_ - 1).count();
}

glm::dvec2 EvenCells::turned(const Turn& turn, glm::dvec2 p) {
  if (turn.flip_x) p.x = 1 - p.x;
  if (turn.flip_y) p.y = 1 - p.y;
  if (turn.swap) std::swap(p.x, p.y);
  return p;
}

EvenCells::Folded EvenCells::fold(std::uint32_t tile, glm::dvec2 p) const {
  const OutsideSides sides = outside_sides(tile_colours(colours_, tile), colours_ - 1);
  Folded folded;
  folded.turns[0] = {sides.right, sides.top, sides.count() == 1 && (sides.left || sides.right)};
  p = turned(folded.turns[0], p);
  if (sides.count() < 2) folded.turns[1].flip_x = p.x > 0.5;
  if (sides.count() == 0) folded.turns[1].flip_y = p.y > 0.5;
  if (sides.count() == 2 && grid_[2].triangle) folded.turns[1].swap = p.y > p.x;
  folded.p = turned(folded.turns[1], p);
  return folded;
}

glm::dvec2 EvenCells::unfolded(const Folded& folded, glm::dvec2 p) {
  for (const int k : {1, 0}) {  // flips are done first, so undone last
    Turn swap = folded.turns[k], flips = folded.turns[k];
    swap.flip_x = swap.flip_y = flips.swap = false;
    p = turned(flips, turned(swap, p));
  }
  return p;
}

glm::uvec2 EvenCells::cell_at(const Grid& grid, glm::dvec2 folded) const {
  const glm::dvec2 at = glm::max(glm::floor(folded / grid.size), 0.0);
  return glm::min(glm::uvec2(at), glm::uvec2(grid.columns - 1, grid.rows - 1));
}

// Below the diagonal row by row, then the pairs on it.
std::uint32_t EvenCells::number_of(const Grid& grid, glm::uvec2 cell) {
  if (!grid.triangle) return cell.x + grid.columns * cell.y;
  if (cell.x == cell.y) return grid.cells - grid.columns / 2 + cell.x / 2;
  return cell.x * (cell.x - 1) / 2 + cell.y;
}

glm::dvec2 EvenCells::low_of(const Grid& grid, std::uint32_t number, glm::dvec2 folded) {
  if (!grid.triangle) return glm::dvec2(number % grid.columns, number / grid.columns) * grid.size;
  const std::uint32_t below = grid.cells - grid.columns / 2;
  if (number >= below) {
    const double first = 2.0 * (number - below);
    const bool second = folded.x + folded.y > 2 * (first + 1) * grid.size.x;
    return (first + (second ? 1 : 0)) * grid.size;
  }
  const auto column = std::uint32_t(std::floor((1 + std::sqrt(1 + 8.0 * number)) / 2));
  return glm::dvec2(column, number - column * (column - 1) / 2) * grid.size;
}

std::uint32_t EvenCells::number(std::uint32_t tile, glm::dvec2 p) const {
  const Grid& grid = grid_[class_of(tile)];
  return number_of(grid, cell_at(grid, fold(tile, p).p));
}

EvenCells::Cell EvenCells::cell(std::uint32_t tile, glm::dvec2 p) const {
  const Grid& grid = grid_[class_of(tile)];
  const Folded folded = fold(tile, p);
  const glm::uvec2 at = cell_at(grid, folded.p);
  const bool twin = grid.triangle && at.x == at.y;
  const glm::dvec2 low = glm::dvec2(twin ? at / 2u * 2u : at) * grid.size;
  const glm::dvec2 a = unfolded(folded, low), b = unfolded(folded, low + (twin ? 2.0 : 1.0) * grid.size);
  Cell cell{glm::min(a, b), glm::abs(b - a), twin ? ((a.x < b.x) == (a.y < b.y) ? 1 : -1) : 0};
  if (!twin) return cell;
  cell.size.y /= 2;
  if (cell.twin < 0) cell.low.y += cell.size.y;
  return cell;
}

double EvenCells::distance2(std::uint32_t tile, glm::dvec2 p, std::uint32_t number) const {
  const Grid& grid = grid_[class_of(tile)];
  const glm::dvec2 folded = fold(tile, p).p;
  const glm::dvec2 d = low_of(grid, number, folded) + 0.5 * grid.size - folded;
  return glm::dot(d, d);
}

glm::dvec2 EvenCells::nearest(std::uint32_t tile, glm::dvec2 p, std::uint32_t number, double margin) const {
  const Grid& grid = grid_[class_of(tile)];
  const Folded folded = fold(tile, p);
  const glm::dvec2 low = low_of(grid, number, folded.p);
  return unfolded(folded, glm::clamp(folded.p, low + margin * grid.size, low + (1 - margin) * grid.size));
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> find_shared_cell(const TileSet& set) {
  const EvenCells cells(set.colours, set.points_per_tile);
  std::array<std::vector<bool>, 3> taken;
  for (int c = 0; c < 3; ++c) taken[c].resize(cells.count(c));
  for (std::uint32_t t = 0; t < set.tiles.size(); ++t)
    for (std::uint32_t r = 0; r < set.tiles[t].size(); ++r) {
      auto mark = taken[cells.class_of(t)][cells.number(t, to_double(set.tiles[t][r].position))];
      if (mark) return std::pair(t, r);
      mark = true;
    }
  return std::nullopt;
}

}  // namespace capcon
