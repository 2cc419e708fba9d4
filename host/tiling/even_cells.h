#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// The cells that make bounded tilings unbiased. A random tiling under a random symmetry of the square shows,
/// in any place, tiles of one class (inner, side or corner), all alike often, in all orientations that the
/// place allows. So each class' points, turned to one orientation, get one cell each of as many equal cells,
/// and a random place in it: every place of the square is then as likely as any other.
///
/// An inner tile's cells are those of a quarter of the tile, which the flips in x and y carry all over it; a
/// side tile's those of a half; a corner tile's those of the half below its diagonal, where pairs of cells
/// that the diagonal cuts count as one; where 8 C n is no even square, those of the whole tile.
class EvenCells {
 public:
  /// Of bounded sets of so many colours, outside included.
  EvenCells(std::uint32_t colours, std::uint32_t points_per_tile);

  /// A cell in the tile: its low corner and size. `twin` +1 or -1: two squares that touch in a corner, side
  /// by side in x (size.x is of both), the second one above or below the first.
  struct Cell {
    glm::dvec2 low{0}, size{0};
    int twin = 0;
  };

  /// 0 inner, 1 side, 2 corner.
  int class_of(std::uint32_t tile) const;
  /// How many cells, and points, a class has.
  std::uint32_t count(int tile_class) const { return grid_[tile_class].cells; }
  /// The number of the cell of its class that a point of a tile lies in.
  std::uint32_t number(std::uint32_t tile, glm::dvec2 p) const;
  /// This cell as it lies about the point.
  Cell cell(std::uint32_t tile, glm::dvec2 p) const;
  /// Squared distance of a point from the middle of a cell of its tile's class, whichever of the
  /// cell's images in the tile is nearest.
  double distance2(std::uint32_t tile, glm::dvec2 p, std::uint32_t number) const;
  /// The nearest place in a cell, `margin` of the cell's size away from its sides.
  glm::dvec2 nearest(std::uint32_t tile, glm::dvec2 p, std::uint32_t number, double margin) const;

 private:
  struct Grid {
    std::uint32_t columns = 1, rows = 1, cells = 1;
    glm::dvec2 size{1};     ///< of a cell
    bool triangle = false;  ///< only cells below the diagonal
  };
  struct Turn {
    bool flip_x = false, flip_y = false, swap = false;
  };
  struct Folded {
    glm::dvec2 p{0};
    std::array<Turn, 2> turns;  ///< to one orientation, then into the part that has the cells
  };
  Folded fold(std::uint32_t tile, glm::dvec2 p) const;
  static glm::dvec2 turned(const Turn& turn, glm::dvec2 p);
  static glm::dvec2 unfolded(const Folded& folded, glm::dvec2 p);
  glm::uvec2 cell_at(const Grid& grid, glm::dvec2 folded) const;
  static std::uint32_t number_of(const Grid& grid, glm::uvec2 cell);
  /// The low corner of the cell of this number that is nearest to a folded point.
  static glm::dvec2 low_of(const Grid& grid, std::uint32_t number, glm::dvec2 folded);

  std::uint32_t colours_;
  std::array<Grid, 3> grid_;
};

/// The first point whose cell another point of its class has, or none: then bounded tilings of the set are
/// unbiased. (tile, rank).
std::optional<std::pair<std::uint32_t, std::uint32_t>> find_shared_cell(const TileSet& set);

}  // namespace capcon
