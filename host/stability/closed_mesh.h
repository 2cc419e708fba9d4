#pragma once

#include "scene/scene.h"

namespace capcon::stability {

/// A closed mesh without boundary: an icosahedron whose sides are cut in four `levels` times (20 * 4^levels
/// triangles), its vertices on a sphere of radius 1 moved outwards, inwards and sideways at random, so that
/// no two edges are alike and many turn away from the middle. It holds a ball of radius 0.5.
TriangleMesh closed_mesh(int levels, std::uint64_t seed);

}  // namespace capcon::stability
