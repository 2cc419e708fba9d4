#pragma once

#include <functional>

#include "generator/mesh.h"

namespace capcon::scenes {

/// A surface over the unit square: u and v from 0 to 1; cross(d/du, d/dv) points out. A direction that wraps
/// ends where it begins.
using Surface = std::function<Vec3(double u, double v)>;
Mesh surface(const Surface& shape, int nu, int nv, bool wrap_u, bool wrap_v);

/// A tube of radius `thickness(t)` about a closed curve, t from 0 to 1. The section is a circle, or what
/// `section(angle, t)` makes of its radius.
Mesh closed_tube(const std::function<Vec3(double)>& curve,
                 const std::function<double(double, double)>& section, int steps, int sides);

/// The (p, q) torus knot about the z axis: p times round the axis, q times round the ring.
Vec3 torus_knot(double t, int p, int q, double ring, double tube);

/// A ball whose radius is shape(direction).
Mesh ball(const std::function<double(const Vec3&)>& shape, int turns, int rows);

/// A beam of round edges: the rectangle of that width (u) and depth (v) with corners of `round`, as a
/// section.
std::vector<Vec2> rounded_rectangle(double width, double depth, double round, int segments);

}  // namespace capcon::scenes
