#pragma once

#include <glm/vec2.hpp>

#include "sampling/sampler.h"

namespace capcon::reference {

/// The upper 24 bits of a point's coordinates, in [0, 1): as many as both sides use.
inline glm::dvec2 unit_point(FixedPoint point) {
  return {static_cast<double>(point.x >> 8) / 16777216.0, static_cast<double>(point.y >> 8) / 16777216.0};
}

}  // namespace capcon::reference
