#pragma once

#include "points/point_set.h"

namespace capcon {

/// Points apart from each other: those that have another within 1e-6 / sqrt(n), a millionth of the spacing,
/// are strewn over an area that as many points may have; the others stay. Points in [0, 1)^2, on the torus.
Points parted(const Points& points);

}  // namespace capcon
