#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/geometry.h"
#include "scene/bvh.h"
#include "scene/scene.h"

namespace capcon {

/// A shape at its place in the space of a tree (the world's or an object's).
struct Placed {
  const Shape* shape;
  glm::dmat4 to_tree;
  std::uint32_t first_id;  ///< of its primitives
};

/// Primitives of a shape: a mesh's triangles, or one.
std::uint64_t primitive_count(const Scene& scene, const Shape& shape);

/// One tree with the texels of its primitives in slot order, as Geometry holds them.
struct GeometryTree {
  Bvh bvh;
  std::vector<glm::uvec4> primitives, details;
  std::vector<Box> boxes;  ///< a few that together hold everything: tighter than one when the tree is turned
};

/// `quadrics` receives the texels of spheres and disks. The tree is empty when there are no shapes.
GeometryTree build_tree(const Scene& scene, std::span<const Placed> placed, const GeometryOptions& options,
                        std::vector<glm::uvec4>& quadrics);

}  // namespace capcon
