#pragma once

#include "points/measure.h"

namespace capcon {

/// `measure` for points in the unit square whose sides do not meet: the Voronoi cells end at the sides (as
/// the cells of the points and their mirror images do), and distances do not wrap. O(n^2).
Measures measure_bounded(const Points& points);

/// The corners of these cells, in [0, 1]^2, counter-clockwise.
std::vector<std::vector<glm::dvec2>> bounded_outlines(const Points& points);

}  // namespace capcon
