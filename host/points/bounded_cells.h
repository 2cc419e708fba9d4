#pragma once

#include "points/region.h"

namespace capcon {

/// Area and centroid of one cell of an ordinary Voronoi diagram.
struct CellMoments {
  double area = 0;
  glm::dvec2 centroid{0};  ///< in [0, 1]^2, the site itself for a cell of area 0
};

/// The Voronoi cells of points in the square or the disk, cut off at its rim, exactly: polygons, with arcs in
/// the disk. Points must lie in the domain. Not for the torus: see voronoi_cells.
std::vector<CellMoments> bounded_cells(const Points& points, Domain domain);

}  // namespace capcon
