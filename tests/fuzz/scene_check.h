#pragma once

#include "scene/scene.h"

namespace capcon::fuzz {

/// What the rest of the program takes for granted of a mesh, and of a scene.
void check_mesh(const TriangleMesh& mesh);
void check_scene(const Scene& scene);
/// Each is one line.
void check_warnings(const std::vector<std::string>& warnings);

}  // namespace capcon::fuzz
