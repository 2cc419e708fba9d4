#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "render/placement.h"
#include "scene/bvh.h"
#include "scene/scene.h"

namespace capcon {

/// A scene as the device walks it: the tree, three texels a primitive in slot order (triangle: vertices 0, 1,
/// 2 as float bits, the first with the primitive's id as fourth word; sphere or disk: only the id, with
/// kQuadricBit), and seven texels a quadric (shaders/tracing/quadric.glsl).
///
/// With two levels the tree at node 0 is one of instances, its slots are instances, and the trees of the
/// objects follow in the same array. An instance has eight texels: three rows of world-to-object, then grid
/// origin and root node, grid scale and first primitive id of its object's tree, then three rows of
/// object-to-world. A primitive's id is counted over all instances: the instance's first plus the one that
/// its slot holds; ids do not depend on the number of levels.
struct Geometry {
  Bvh bvh;  ///< `order` is that of the tree at node 0
  std::vector<glm::uvec4> primitives;
  std::vector<glm::uvec4> quadrics;
  std::vector<glm::uvec4> instances;  ///< empty: one level
  /// What shading needs of a slot, if asked for: a texel (light word, z of normal 2, 0, material), with
  /// normals two more (normals 0 and 1, each with one of x and y of normal 2; zeros where a mesh has none),
  /// with uvs two more (uvs 0 and 1; uv 2).
  std::vector<glm::uvec4> details;
  std::uint64_t triangle_count = 0;  ///< those of instances counted for each
  std::uint64_t quadric_count = 0;
  std::size_t instance_count() const { return instances.size() / 8; }
};

/// What details hold.
struct DetailOptions {
  bool wanted = false;
  bool normals = false, uvs = false;
  /// For each of Scene::shapes: empty (no light), one light word for all its primitives, or one for each:
  /// index of the light, with layout::kLightTurned where it shines against the order of the vertices.
  std::vector<std::vector<std::uint32_t>> light_words = {};
  std::uint32_t default_material = 0;  ///< of shapes without one
  std::uint32_t texels() const { return wanted ? 1 + (normals ? 2 : 0) + (uvs ? 2 : 0) : 0; }
};

struct GeometryOptions {
  bool two_level = false;  ///< a tree of instances above those of the objects
  bool keep_instances =
      false;  ///< with two levels: whether instances stay instances, or are written out into the world's tree
  DetailOptions details = {};
  Placement placement = {};  ///< of the world in the device's space
  bool cut = true;           ///< primitives where that makes a better tree (wants_best_tree())
};

/// Instances are written out in world space for one level; vertices are transformed in double and rounded to
/// float once. With two levels, spheres and disks of instances and instances that are squeezed flat still go
/// into the world's own tree. InputError when the scene holds nothing that can be seen, Failure when it is
/// larger than the tree can index.
Geometry build_geometry(const Scene& scene, const GeometryOptions& options = {});

}  // namespace capcon
