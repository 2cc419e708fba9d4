#pragma once

#include <functional>

#include "generator/mesh.h"

namespace capcon::scenes {

/// Faces of a box, to leave out those that touch something else.
enum Face : unsigned {
  kWest = 1,
  kEast = 2,
  kSouth = 4,
  kNorth = 8,
  kBottom = 16,
  kTop = 32,
  kUpright = 15,
  kAllFaces = 63
};

Mesh box(const Vec3& low, const Vec3& high, unsigned faces = kAllFaces);

/// A box with all its edges bevelled by `bevel`: 44 triangles.
Mesh bevelled_box(const Vec3& low, const Vec3& high, double bevel);

/// A paving stone without underside: four corners of its top (counter-clockwise from above), reaching down to
/// `bottom`, the upper edges bevelled by `bevel`.
Mesh paving_stone(const std::array<Vec3, 4>& top, double bottom, double bevel);

/// A horizontal disc facing up.
Mesh disc(double radius, double z, int segments);

/// Turns a profile of (radius, height), listed with the solid on its left (bottom to top for a column), about
/// the z axis. `shape(angle, height)` scales the radius: flutes, gadroons.
using RadiusShape = std::function<double(double angle, double height)>;
Mesh lathe(const std::vector<Vec2>& profile, int segments, const RadiusShape& shape = {});

/// A closed or open section moved along a path of frames; the section's (u, v) become u * right + v * up,
/// where cross(right, up) is the way ahead. The section goes counter-clockwise round the solid.
struct Frame {
  Vec3 origin, right, up;
};
enum class Ends { open, closed_loop, capped };
Mesh sweep(const std::vector<Vec2>& section, bool section_closed, const std::vector<Frame>& path, Ends ends);

/// A straight moulding along a polyline in plan with mitred corners: the section's u is to the left of the
/// path, v is up.
Mesh moulding(const std::vector<Vec2>& section, const std::vector<Vec3>& path, bool loop);

/// A round bar through the points, of the given radius at each.
Mesh tube(const std::vector<Vec3>& points, const std::vector<double>& radii, int sides, bool capped = true);

}  // namespace capcon::scenes
