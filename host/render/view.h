#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace capcon {

/// The camera as rays through film positions in pixels: direction = corner + x across + y down, not
/// normalised.
struct View {
  glm::dvec3 eye, corner, across, down;
};

/// pbrt's perspective camera (Pharr et al. 2016, section 6.2.2): the screen window spans [-1, 1] on the
/// shorter axis.
View make_view(const Camera& camera, int width, int height);

}  // namespace capcon
