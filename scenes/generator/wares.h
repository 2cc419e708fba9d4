#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// A bowl with lobes on z = 0, inside and outside; its rim has that radius.
Mesh gadrooned_bowl(double radius, double height, int lobes, int segments);

/// A drum with a rounded upper edge and a top, from z = -0.01 to `height`.
Mesh drum(double radius, double height, int segments);

/// A bellied vase whose lobes wind as they rise, on z = 0 up to `height`.
Mesh swirled_vase(double height, int lobes, int segments, int rows);

/// A ring of a three-lobed bar that turns once on its way, upright: its axis is y, its lowest point about z =
/// 0.
Mesh lobed_ring(double ring, double bar, int steps, int sides);

/// A ball of spiral lobes about the z axis, centre at the origin.
Mesh spiral_ball(double radius, int turns, int rows);

/// A shell wound by the logarithmic spiral in the plane y = 0, `size` across; its lowest point is about z =
/// 0.
Mesh nautilus(double size, int steps, int sides);

/// A lemon along x, centre at the origin.
Mesh lemon(double length, int turns, int rows);

}  // namespace capcon::scenes
