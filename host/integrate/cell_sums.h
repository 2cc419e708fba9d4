#pragma once

#include <vector>

#include "points/point_set.h"

namespace capcon::integrate {

/// What weights and bounds need of the Voronoi cells V_i of points x_i in a domain of area 1; z_i is a cell's
/// centroid.
struct CellSums {
  std::vector<double> areas;  ///< in the points' order; their sum is 1
  double energy = 0;          ///< E = sum_i integral over V_i of |x - x_i|^2
  double off_centre = 0;      ///< F = sum_i area_i |z_i - x_i|, 0 for centroidal points
};

/// Figures of each cell on the torus, in the points' order. A shift on the torus changes none of them.
struct TorusCells {
  std::vector<double> areas, second_moments, off_centre;
  std::vector<double> reach;  ///< no site farther away than this from the cell's own takes part in its shape
};

/// Coincident points: the first has the cell, the others area 0.
TorusCells torus_cells(const Points& points);
CellSums torus_sums(const TorusCells& cells);

/// Cells in the square, cut off at its sides, given those of the same points on the torus.
CellSums square_sums(const Points& points, const TorusCells& cells);

/// |integral of f - sum_i area_i f(x_i)| is at most this for every twice differentiable f on the cells'
/// domain with |grad f| <= gradient and ||second derivatives||_2 <= hessian. By Taylor's formula about x_i,
/// along a segment that stays in the convex cell: f(x) = f(x_i) + grad f(x_i).(x - x_i) + r, |r| <= hessian
/// |x - x_i|^2 / 2. Integrated over all cells the remainders are at most hessian E / 2 and the linear terms
/// sum_i area_i grad f(x_i).(z_i - x_i) at most gradient F.
double second_derivative_bound(const CellSums& cells, double gradient, double hessian);

}  // namespace capcon::integrate
