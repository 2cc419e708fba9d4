#pragma once

#include <string>

#include "generator/mesh.h"

namespace capcon::scenes {

/// The mesh as a binary little-endian PLY file: float x y z, nx ny nz where
/// there are normals, triangles as lists of uchar and int.
std::string ply_bytes(const Mesh& mesh);

}  // namespace capcon::scenes
