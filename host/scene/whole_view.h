#pragma once

#include "scene/scene.h"

namespace capcon {

/// A camera for a mesh that comes without one: y up, from a three-quarter view above, all vertices that
/// triangles use in the image.
Camera whole_view(const TriangleMesh& mesh);

}  // namespace capcon
