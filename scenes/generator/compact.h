#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// Makes a mesh ready for a file: vertices that agree to the last bit of a float become one, unused ones go,
/// and so do triangles that rounding has made degenerate. The order of what stays does not change.
void compact(Mesh& mesh);

}  // namespace capcon::scenes
