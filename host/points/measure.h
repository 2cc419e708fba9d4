#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "points/point_set.h"

namespace capcon {

/// One cell of the periodic Voronoi diagram of a point set on the unit torus.
struct VoronoiCell {
  std::vector<glm::dvec2> corners;  ///< counter-clockwise, relative to the site (not wrapped)
  double area = 0;
  glm::dvec2 centroid{0};    ///< relative to the site
  double second_moment = 0;  ///< integral over the cell of |x - site|^2
};

/// Exact polygons by clipping with the bisectors of neighbours. Coincident points share their cell's area:
/// the first keeps the cell, the others have area 0 and no corners. Coordinates must lie in [0, 1).
std::vector<VoronoiCell> voronoi_cells(const Points& points);

/// n E of the regular hexagonal lattice, the smallest there is: 5 / (18 sqrt 3).
inline constexpr double kHexagonEnergy = 0.16037507477489604;

/// What `capcon measure` reports; distances are toroidal, d_hex = sqrt(2 / (sqrt(3) n)).
struct Measures {
  std::size_t n = 0;
  double delta_min = 0;   ///< smallest distance / d_hex
  double delta_mean = 0;  ///< mean nearest-neighbour distance / d_hex
  double energy = 0;      ///< n E / (5 / (18 sqrt 3)), ordinary Voronoi cells; 1 = hexagons
  double area_sd = 0;     ///< standard deviation of n * area
};

/// All zero for no points; for one point the nearest neighbour is its own image, at distance 1.
Measures measure(const Points& points);
nlohmann::json to_json(const Measures& measures);

}  // namespace capcon
