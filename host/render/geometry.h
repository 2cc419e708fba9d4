#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/bvh.h"
#include "scene/scene.h"

namespace capcon {

/// A scene as the device walks it: the tree, three texels a primitive in slot order (triangle: vertices 0, 1, 2 as float
/// bits, the first with the primitive's id as fourth word; sphere or disk: only the id, with kQuadricBit), and seven texels
/// a quadric (shaders/tracing/quadric.glsl).
struct Geometry {
  Bvh bvh;
  std::vector<glm::uvec4> primitives;
  std::vector<glm::uvec4> quadrics;
  std::uint64_t triangle_count = 0;
  std::uint64_t quadric_count = 0;
};

/// Instances are written out in world space; vertices are transformed in double and rounded to float once. InputError when
/// the scene holds nothing that can be seen, Failure when it is larger than the tree can index.
Geometry build_geometry(const Scene& scene);

}  // namespace capcon
