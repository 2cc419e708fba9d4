#pragma once

#include "scene/scene.h"

namespace capcon {

/// Steps of a full turn about z, and of the half turn from pole to pole, of the meshes below. The chord of a
/// step leaves the true surface by 1.9e-5 of the radius.
inline constexpr int kTurnSteps = 512;
inline constexpr int kPoleSteps = 256;

/// The part of a sphere about the origin between z_min and z_max and from 0 to phi_max degrees about z.
/// Triangles face outwards.
TriangleMesh tessellate_sphere(double radius, double z_min, double z_max, double phi_max_degrees);

/// The part of a ring in the plane z = height from 0 to phi_max degrees. Triangles face +z.
TriangleMesh tessellate_disk(double radius, double inner_radius, double height, double phi_max_degrees);

}  // namespace capcon
