#pragma once

#include "generator/profiles.h"

namespace capcon::scenes {

/// Wedge stones round a round arch in a wall at y = 0 that faces -y, springing at z, standing `out` of the
/// wall; `depth` is measured along the radius. The keystone is larger.
Mesh voussoirs(double radius, double depth, double out, int count, double z);

/// Sections of a balustrade's rails, for moulding(): the foot rail from 0 up, the hand rail from `z` to z +
/// 0.11.
Profile foot_rail();
Profile hand_rail(double z);

/// A square newel with a moulded cap and a ball, on z = 0; `height` is without the ball.
Mesh newel(double height, double half_width);

}  // namespace capcon::scenes
