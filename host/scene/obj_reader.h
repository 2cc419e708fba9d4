#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace capcon {

/// Reads a Wavefront OBJ file from memory: v, vt, vn and f (with negative indices; polygons become fans of
/// triangles) as one mesh; every other statement is passed over. Normals and uvs are kept only if all corners
/// have them. `name` is what messages call the file. InputError with name:line.
TriangleMesh parse_obj(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

}  // namespace capcon
