#pragma once

#include <limits>
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

/// What `capcon measure` reports; distances are toroidal, d_hex = sqrt(2 / (sqrt(3) n)). docs/measures.md
/// says more.
struct Measures {
  std::size_t n = 0;
  double delta_min = 0;       ///< smallest distance / d_hex
  double delta_mean = 0;      ///< mean nearest-neighbour distance / d_hex
  double energy = 0;          ///< n E / (5 / (18 sqrt 3)), ordinary Voronoi cells; 1 = hexagons
  double area_sd = 0;         ///< standard deviation of n * area
  double capacity_error = 0;  ///< E' = (1/n) sum (n area - 1)^2 = area_sd^2
  double centroid_rms = 0;  ///< root of the mean squared distance from point to centroid of its cell, / d_hex
  double psi6 = 0;  ///< |mean of psi6_i|, psi6_i = sum over edges of (length / perimeter) exp(6i angle): one
                    ///< direction of hexagons for all: 1 = hexagonal lattice
  double psi6_local = 0;  ///< mean of |psi6_i|: hexagons, however each is turned
  // The rest is measured by measure_fully alone; NaN = not measured.
  double energy_ot =
      std::numeric_limits<double>::quiet_NaN();  ///< least transport energy to n equal masses, 1 = hexagons
  double star = std::numeric_limits<double>::quiet_NaN();     ///< star discrepancy: discrepancy.h
  double l2_star = std::numeric_limits<double>::quiet_NaN();  ///< L2-star discrepancy: discrepancy.h
};

/// All zero for no points; for one point the nearest neighbour is its own image, at distance 1. O(n), on all
/// threads, the same bits for any number of them.
Measures measure(const Points& points);

/// The slow measures are made up to this many points unless more is asked for.
inline constexpr std::size_t kFullMeasureLimit = 16384;

/// `measure` and the discrepancies and, up to `limit` points, what costs more than O(n log n). energy_ot
/// stays NaN where transport_energy fails.
Measures measure_fully(const Points& points, std::size_t limit = kFullMeasureLimit);

/// The mean of each measure; all n alike or n = 0. NaN where one is NaN.
Measures mean_of(const std::vector<Measures>& all);

/// A measure's name (as in JSON) and where it is kept, in the order in which they are shown; without n.
struct MeasureField {
  const char* name;
  double Measures::*value;
};
const std::vector<MeasureField>& measure_fields();

/// What was not measured is left out.
nlohmann::ordered_json to_json(const Measures& measures);

}  // namespace capcon
