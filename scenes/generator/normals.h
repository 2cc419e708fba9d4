#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// Gives a compact mesh one normal a vertex: the mean of its triangles' normals, weighted by their angles
/// there (Thuermer and Wuethrich, JGT 3(1), 1998). Triangles that meet at more than `crease` degrees do not
/// smooth each other: where they share a vertex it is doubled.
void add_normals(Mesh& mesh, double crease);

}  // namespace capcon::scenes
