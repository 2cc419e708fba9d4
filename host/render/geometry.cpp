#include "render/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "layout.h"
#include "render/geometry_tree.h"

namespace capcon {
namespace {

constexpr std::uint64_t kMaxPrimitives = 1u << 30;
constexpr std::size_t kMaxNodes = 1u << 24;
// To enter an instance is to walk its tree, relative to a triangle's test: nearly every one gets a box of its
// own.
constexpr double kInstanceCost = 20;

/// Whether the matrix squeezes space so flat that a ray cannot be brought into it.
bool is_flat(const glm::dmat4& m) {
  const double volume = std::abs(glm::determinant(glm::dmat3(m)));
  return !(volume > 1e-9 * glm::length(glm::dvec3(m[0])) * glm::length(glm::dvec3(m[1])) *
                        glm::length(glm::dvec3(m[2])));
}

/// The world's shapes and instances with their primitive ids.
struct Census {
  std::vector<Placed> world;  ///< in the device's space: what is in no object, and with one level everything
  std::vector<std::uint32_t>
      instances;  ///< of those that keep their object's tree: index into scene.instances
  std::vector<std::uint32_t> first_ids;  ///< of their primitives
  std::uint64_t count = 0, quadrics = 0;
};

Census take_census(const Scene& scene, bool keep_instances, const Placement& placement) {
  Census census;
  const glm::dmat4 to_device = placement.matrix();
  const auto place = [&](const Shape& shape, const glm::dmat4& to_world, bool keep) {
    if (!keep)
      census.world.push_back({&shape, to_device * to_world, static_cast<std::uint32_t>(census.count)});
    census.count += primitive_count(scene, shape);
    if (shape.kind != ShapeKind::mesh) ++census.quadrics;
    if (census.count >= kMaxPrimitives) {
      throw Failure(
          fmt::format("{}: more than {} primitives after instancing are more than ids can tell apart",
                      scene.name, kMaxPrimitives));
    }
  };
  for (const Shape& shape : scene.shapes) place(shape, shape.to_world, false);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const bool keep = keep_instances && !is_flat(instance.to_world);
    const auto first = static_cast<std::uint32_t>(census.count);
    bool triangles = false;
    for (const Shape& shape : scene.objects[instance.object].shapes) {
      const bool mesh = shape.kind == ShapeKind::mesh;
      place(shape, instance.to_world * shape.to_world, keep && mesh);
      triangles = triangles || (mesh && primitive_count(scene, shape) > 0);
    }
    if (!keep || !triangles) continue;
    census.instances.push_back(i);
    census.first_ids.push_back(first);
  }
  return census;
}

/// The trees of objects, and of the world last; only those that instances use are built.
std::vector<GeometryTree> build_trees(const Scene& scene, const Census& census,
                                      const GeometryOptions& options, std::vector<glm::uvec4>& quadrics) {
  std::vector<char> used(scene.objects.size());
  for (const std::uint32_t i : census.instances) used[scene.instances[i].object] = 1;
  std::vector<GeometryTree> trees(scene.objects.size() + 1);
  parallel_for(scene.objects.size(), [&](std::size_t o) {
    if (!used[o]) return;
    std::vector<Placed> placed;
    std::uint32_t id = 0;
    for (const Shape& shape : scene.objects[o].shapes) {
      if (shape.kind == ShapeKind::mesh) placed.push_back({&shape, shape.to_world, id});
      id += static_cast<std::uint32_t>(primitive_count(scene, shape));
    }
    std::vector<glm::uvec4> none;
    trees[o] = build_tree(scene, placed, options, none);
  });
  trees.back() = build_tree(scene, census.world, options, quadrics);
  return trees;
}

/// The box of a tree's boxes under a matrix, grown by the device's rounding.
Box moved_box(const std::vector<Box>& boxes, const glm::dmat4& m) {
  Box all;
  for (const Box& b : boxes) {
    const glm::dvec3 half = 0.5 * (b.high - b.low);
    const glm::dvec3 centre = glm::dvec3(m * glm::dvec4(0.5 * (b.high + b.low), 1));
    glm::dvec3 extent(0);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) extent[row] += std::abs(m[column][row]) * half[column];
      extent[row] += 1e-6 * (extent[row] + std::abs(centre[row]));
    }
    all.add(Box{centre - extent, centre + extent});
  }
  return all;
}

glm::uvec4 texel(glm::dvec4 v) {
  const glm::vec4 f(v);
  return {std::bit_cast<std::uint32_t>(f.x), std::bit_cast<std::uint32_t>(f.y),
          std::bit_cast<std::uint32_t>(f.z), std::bit_cast<std::uint32_t>(f.w)};
}

glm::uvec4 texel(glm::dvec3 v, std::uint32_t w) {
  glm::uvec4 t = texel(glm::dvec4(v, 0));
  t.w = w;
  return t;
}

void append_rows(const glm::dmat4& m, std::vector<glm::uvec4>& out) {
  for (int row = 0; row < 3; ++row)
    out.push_back(texel(glm::dvec4(m[0][row], m[1][row], m[2][row], m[3][row])));
}

/// Where a tree lies in the arrays that hold all.
struct Base {
  std::uint32_t node = 0, slot = 0;
};

/// Appends a tree, its links moved to where it lies.
void append(const GeometryTree& tree, Base base, Geometry& geometry) {
  glm::uvec4* out = geometry.bvh.texels.data() + 4 * std::size_t(base.node);
  std::copy(tree.bvh.texels.begin(), tree.bvh.texels.end(), out);
  for (std::size_t n = 0; n < tree.bvh.node_count(); ++n) {
    out[4 * n + 3].x += base.node << 4;
    out[4 * n + 3].y += base.slot;
  }
  std::copy(tree.primitives.begin(), tree.primitives.end(),
            geometry.primitives.begin() + 3 * std::ptrdiff_t(base.slot));
  const std::size_t stride = tree.primitives.empty() ? 0 : 3 * tree.details.size() / tree.primitives.size();
  std::copy(tree.details.begin(), tree.details.end(),
            geometry.details.begin() + std::ptrdiff_t(stride * base.slot));
}

/// The tree of instances, with the trees below it.
void assemble(const Scene& scene, const Census& census, const std::vector<GeometryTree>& trees,
              const GeometryOptions& options, Geometry& geometry) {
  struct Member {
    std::size_t tree;
    glm::dmat4 to_world;
    std::uint32_t first_id;
  };
  const glm::dmat4 to_device = options.placement.matrix();
  std::vector<Member> members;
  if (trees.back().bvh.node_count() > 0) members.push_back({trees.size() - 1, glm::dmat4(1), 0});
  for (std::size_t i = 0; i < census.instances.size(); ++i) {
    const Instance& instance = scene.instances[census.instances[i]];
    members.push_back({instance.object, to_device * instance.to_world, census.first_ids[i]});
  }
  std::vector<Box> boxes(members.size());
  parallel_for(
      members.size(),
      [&](std::size_t i) { boxes[i] = moved_box(trees[members[i].tree].boxes, members[i].to_world); }, 64);
  geometry.bvh = build_bvh(boxes, kInstanceCost);

  std::vector<Base> bases(trees.size());
  std::size_t nodes = geometry.bvh.node_count(), slots = 0;
  std::uint32_t deepest = 0;
  for (std::size_t t = 0; t < trees.size(); ++t) {
    bases[t] = {static_cast<std::uint32_t>(nodes), static_cast<std::uint32_t>(slots)};
    nodes += trees[t].bvh.node_count();
    slots += trees[t].primitives.size() / 3;
    if (trees[t].bvh.node_count() > 0) deepest = std::max(deepest, trees[t].bvh.stack_entries);
  }
  geometry.bvh.texels.resize(4 * nodes);
  geometry.primitives.resize(3 * slots);
  geometry.details.resize(options.details.texels() * slots);
  for (std::size_t t = 0; t < trees.size(); ++t) append(trees[t], bases[t], geometry);
  geometry.bvh.stack_entries += deepest + 1;  // one marks where the object's tree ends

  geometry.instances.reserve(8 * geometry.bvh.order.size());
  for (const std::uint32_t i : geometry.bvh.order) {
    const Member& m = members[i];
    const Bvh& bvh = trees[m.tree].bvh;
    append_rows(glm::inverse(m.to_world), geometry.instances);
    const bool own = m.tree + 1 == trees.size();
    geometry.instances.push_back(
        texel(bvh.grid_origin, bases[m.tree].node | (own ? layout::kWorldInstance : 0)));
    geometry.instances.push_back(texel(bvh.grid_scale, m.first_id));
    append_rows(m.to_world, geometry.instances);
  }
}

}  // namespace

Geometry build_geometry(const Scene& scene, const GeometryOptions& options) {
  const Census census = take_census(scene, options.two_level && options.keep_instances, options.placement);
  if (census.count == 0)
    throw InputError(scene.name + ": the scene has no shapes, so there is nothing to render");
  Geometry geometry;
  if (options.two_level) {
    const std::vector<GeometryTree> trees = build_trees(scene, census, options, geometry.quadrics);
    assemble(scene, census, trees, options, geometry);
  } else {
    GeometryTree tree = build_tree(scene, census.world, options, geometry.quadrics);
    geometry.bvh = std::move(tree.bvh);
    geometry.primitives = std::move(tree.primitives);
    geometry.details = std::move(tree.details);
  }
  geometry.quadric_count = census.quadrics;
  geometry.triangle_count = census.count - census.quadrics;
  if (geometry.bvh.node_count() >= kMaxNodes) {
    throw Failure(fmt::format("{}: {} nodes are more than the tree can index; try --instancing two-level",
                              scene.name, geometry.bvh.node_count()));
  }
  return geometry;
}

}  // namespace capcon
