#pragma once

#include <vector>

#include "generator/mesh.h"

namespace capcon::scenes {

enum class Arch { flat, round, segmental, pointed };

/// The underside of an arch from the left springing to the right, (u, height above the springing), u from
/// -half to half.
std::vector<Vec2> arch_curve(Arch arch, double half_width, int segments);

struct Opening {
  double centre = 0;  ///< along the wall
  double half_width = 1;
  double sill = 0;       ///< height; at or below the wall's foot for a door
  double springing = 2;  ///< height where the arch begins
  Arch arch = Arch::round;
  int segments = 24;
};

/// A wall along x from `from` to `to`, z from `foot` to `head`, its front at y = 0 facing -y, its back at y =
/// thickness.
struct WallPlan {
  double from = 0, to = 1, foot = 0, head = 1, thickness = 0.3;
  double slope = 0;  ///< the head rises by this for every metre after `from`
  bool front = true, back = true, top = true, ends = false;
  std::vector<Opening> openings = {};  ///< from left to right, not touching
};
Mesh wall(const WallPlan& plan);

/// A moulding round an opening's head on the front of a wall at y = 0: the section's u is away from the
/// opening, v out of the wall (-y). With `jambs` it runs down both sides to the sill as well.
Mesh archivolt(const Opening& opening, const std::vector<Vec2>& section, bool jambs);

}  // namespace capcon::scenes
