#pragma once

#include "tiling/even_cells.h"
#include "tiling/tied_points.h"

namespace capcon {

/// Moves every free point of a bounded set into a cell of its own (EvenCells). First each class' points are
/// dealt to its cells so that the sum of squared ways is least: an optimal assignment (Kuhn 1955, by shortest
/// augmenting paths; O(n^3) for the n points of a class). Then pairs of points exchange their cells while
/// that lowers the squared ways and the squares of every tile's first and second moments about those of the
/// whole tile: a tile alone then integrates what is smooth. `settled` in [0, 1]: 0 leaves points where they
/// are in their cells and moments alone; 1 puts points in the middle of their cells, from where a random
/// place in the cell strays as little as can be.
void make_even(TiedPoints& points, double settled);

/// Takes points that have moved since back to the nearest place in the cell that each had.
void keep_in_cells(TiedPoints& moved, const TiedPoints& placed);

}  // namespace capcon
