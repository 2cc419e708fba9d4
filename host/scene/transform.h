#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace capcon {

/// Rotation by `degrees` about `axis` (any length but 0), counter-clockwise seen against the axis in a
/// right-handed frame.
glm::dmat4 rotation(double degrees, const glm::dvec3& axis);

/// pbrt's LookAt: world to a left-handed camera space at `eye`, +z towards `target`, +y up, +x = cross(up,
/// forward).
glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

/// Whether a transform cannot be inverted in double precision: its axes are (nearly) dependent, zero or not
/// finite. It does not depend on the unit of length.
bool is_singular(const glm::dmat4& transform);

/// Whether the last row is 0 0 0 1, to 1e-6.
bool is_affine(const glm::dmat4& transform);

}  // namespace capcon
