#pragma once

#include "points/point_set.h"

namespace capcon::integrate {

/// The exact star discrepancy of points of the unit square, in O(n^2): the largest difference between the
/// area of a box [0,x) x [0,y) and the share of points in it (Bundschuh and Zhu 1993).
double star_discrepancy(const Points& points);

}  // namespace capcon::integrate
