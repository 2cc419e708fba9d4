#pragma once

#include <glm/vec3.hpp>

#include "render/placement.h"
#include "scene/scene.h"

namespace capcon {

/// The camera as rays through film positions in pixels: direction = corner + x across + y down, not
/// normalised, from first + start (x across + y down). From afar rays start on a plane before the scene,
/// whose points are known to the scene's digits and not to those of the distance.
struct View {
  glm::dvec3 eye, corner, across, down;
  glm::dvec3 first{0};  ///< eye + start corner
  double start = 0;     ///< in lengths of direction: 0 for cameras near the scene
};

/// pbrt's perspective camera (Pharr et al. 2016, section 6.2.2): the screen window spans [-1, 1] on the
/// shorter axis.
View make_view(const Camera& camera, int width, int height);
/// The same in the device's space, of a scene with these bounds (of the world).
View make_view(const Camera& camera, int width, int height, const Placement& placement,
               const BoundingSphere& bounds);

}  // namespace capcon
