#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace capcon {

/// Reads a PLY file from memory: ascii or binary of either byte order. `vertex` must have x y z (and may have
/// nx ny nz; u v, s t or texture_u texture_v), `face` a list vertex_indices or vertex_index; polygons become
/// fans of triangles, everything else is skipped. `name` is what messages call the file. InputError with
/// name:line for the header, with "vertex 17" or "face 3" for the data.
TriangleMesh parse_ply(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

}  // namespace capcon
