#include "render/geometry.h"

#include <fmt/format.h>

#include <bit>
#include <functional>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "layout.h"

namespace capcon {
namespace {

/// A shape at its place in the world.
struct Placed {
  const Shape* shape;
  glm::dmat4 to_world;
  std::size_t first;  // index of its first primitive
};

std::vector<Placed> place_all(const Scene& scene) {
  std::vector<Placed> all;
  for (const Shape& shape : scene.shapes) all.push_back({&shape, shape.to_world, 0});
  for (const Instance& instance : scene.instances) {
    for (const Shape& shape : scene.objects[instance.object].shapes) {
      all.push_back({&shape, instance.to_world * shape.to_world, 0});
    }
  }
  return all;
}

glm::uvec4 bits(glm::vec3 p, std::uint32_t w) {
  return {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y), std::bit_cast<std::uint32_t>(p.z), w};
}

/// World-to-unit-shape and its inverse: the radius and a disk's height are part of the matrix.
void add_quadric(const Placed& placed, Geometry& geometry, Box& box) {
  const Shape& shape = *placed.shape;
  const bool disk = shape.kind == ShapeKind::disk;
  glm::dmat4 unit(1);
  unit[0][0] = unit[1][1] = unit[2][2] = shape.radius;
  if (disk) unit[3][2] = shape.height;
  const glm::dmat4 to_world = placed.to_world * unit;
  const glm::dmat4 to_object = glm::inverse(to_world);
  for (const glm::dmat4* m : {&to_object, &to_world}) {
    for (int row = 0; row < 3; ++row) {
      const glm::vec4 r((*m)[0][row], (*m)[1][row], (*m)[2][row], (*m)[3][row]);
      geometry.quadrics.push_back(bits(glm::vec3(r), std::bit_cast<std::uint32_t>(r.w)));
    }
  }
  const double inner = disk ? shape.inner_radius / shape.radius : 0;
  const auto inner2 = std::bit_cast<std::uint32_t>(static_cast<float>(inner * inner));
  geometry.quadrics.emplace_back(disk ? layout::kQuadricDisk : layout::kQuadricSphere, inner2, 0, 0);
  // Half extents of the image of the unit sphere (or disk) under the matrix: the norms of its rows.
  for (int row = 0; row < 3; ++row) {
    double squares = 0;
    for (int column = 0; column < (disk ? 2 : 3); ++column) squares += to_world[column][row] * to_world[column][row];
    const double centre = to_world[3][row], half = std::sqrt(squares);
    const double rounding = 1e-5 * half + 1e-6 * std::abs(centre);  // the device tests quadrics in float
    box.low[row] = centre - half - rounding;
    box.high[row] = centre + half + rounding;
  }
}

}  // namespace

Geometry build_geometry(const Scene& scene) {
  std::vector<Placed> placed = place_all(scene);
  std::size_t count = 0;
  for (Placed& p : placed) {
    p.first = count;
    count += p.shape->kind == ShapeKind::mesh ? scene.meshes[p.shape->mesh].triangles.size() : 1;
  }
  if (count == 0) throw InputError(scene.name + ": the scene has no shapes, so there is nothing to render");
  if (count >= (1u << 30)) {
    throw Failure(fmt::format("{}: {} primitives after instancing are more than the tree can index", scene.name, count));
  }
  Geometry geometry;
  std::vector<Box> boxes(count);
  std::vector<glm::uvec4> primitives(3 * count);
  for (const Placed& p : placed) {
    if (p.shape->kind == ShapeKind::mesh) continue;
    const auto id = layout::kQuadricBit | static_cast<std::uint32_t>(geometry.quadric_count++);
    add_quadric(p, geometry, boxes[p.first]);
    primitives[3 * p.first] = glm::uvec4(0, 0, 0, id);
  }
  parallel_for(placed.size(), [&](std::size_t s) {
    const Placed& p = placed[s];
    if (p.shape->kind != ShapeKind::mesh) return;
    const TriangleMesh& mesh = scene.meshes[p.shape->mesh];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::size_t at = p.first + t;
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec3 v = glm::dvec3(p.to_world * glm::dvec4(mesh.positions[mesh.triangles[t][corner]], 1));
        boxes[at].add(glm::dvec3(v));
        primitives[3 * at + corner] = bits(v, corner == 0 ? static_cast<std::uint32_t>(at) : 0);
      }
    }
  });
  geometry.triangle_count = count - geometry.quadric_count;
  geometry.bvh = build_bvh(boxes);
  if (geometry.bvh.node_count() >= (1u << 24)) {
    throw Failure(fmt::format("{}: {} nodes are more than the tree can index", scene.name, geometry.bvh.node_count()));
  }
  geometry.primitives.resize(3 * count);
  parallel_for(
      count,
      [&](std::size_t slot) {
        for (int k = 0; k < 3; ++k) geometry.primitives[3 * slot + k] = primitives[3 * std::size_t(geometry.bvh.order[slot]) + k];
      },
      1 << 14);
  return geometry;
}

}  // namespace capcon
