#pragma once

#include <vector>

#include "points/point_set.h"

namespace capcon {

/// The unit square, whose sides do not meet, as a quarter of a torus of twice the size: points and their
/// mirror images about both axes. The power cells there end at the square's sides, as an image has the weight
/// of its point: cut off by the square they are the square's own. n points become 4n: all of them, then their
/// images in x, in y, in both.
Points mirrored(const Points& points);
/// The n points again.
Points unmirrored(const Points& points);

/// Makes the values of a point and its images the same, vectors but for the signs: their means. Rounding
/// would let them part in the course of many steps.
void make_alike(std::vector<double>& values);
void make_alike(std::vector<glm::dvec2>& vectors);

}  // namespace capcon
