#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "shading/light.h"
#include "shading/scene_bounds.h"

namespace capcon {

/// Where a scene lies in the device's own space, in which everything is a float: p -> scale (p - origin),
/// taken in double. Near the camera coordinates are small, and the scene is about as large as 1, so that
/// neither where a scene lies nor its unit of length costs digits. Radiance stays as it is.
struct Placement {
  glm::dvec3 origin{0};
  double scale = 1;  ///< a power of 2: a scene in other units gives the same bits

  glm::dmat4 matrix() const;
  glm::dvec3 to_device(const glm::dvec3& p) const { return scale * (p - origin); }
  glm::dvec3 to_world(const glm::dvec3& p) const { return p / scale + origin; }
};

/// The origin is the camera within the scene's bounds, their centre from outside, on a grid so coarse that
/// round numbers stay round; nothing moves where that is nearer to the world's origin than twice the radius
/// of the bounds. The scale is 1 for scenes of usual size (a bounding sphere of radius 1/16 ... 4096).
Placement place_scene(const BoundingSphere& bounds, const glm::dvec3& camera);

/// Lights in the device's space; a point light's intensity goes with the square of lengths, so that
/// irradiance stays.
void place_lights(Lights& lights, const Placement& placement);

}  // namespace capcon
