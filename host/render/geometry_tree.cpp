#include "render/geometry_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <type_traits>

#include "base/parallel.h"
#include "layout.h"

namespace capcon {
namespace {

glm::uvec4 bits(glm::vec3 p, std::uint32_t w) {
  return {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
          std::bit_cast<std::uint32_t>(p.z), w};
}

/// World-to-unit-shape and its inverse: the radius and a disk's height are part of the matrix.
void add_quadric(const Placed& placed, std::vector<glm::uvec4>& quadrics, Box& box) {
  const Shape& shape = *placed.shape;
  const bool disk = shape.kind == ShapeKind::disk;
  glm::dmat4 unit(1);
  unit[0][0] = unit[1][1] = unit[2][2] = shape.radius;
  if (disk) unit[3][2] = shape.height;
  const glm::dmat4 to_tree = placed.to_tree * unit;
  const glm::dmat4 to_object = glm::inverse(to_tree);
  for (const glm::dmat4* m : {&to_object, &to_tree}) {
    for (int row = 0; row < 3; ++row) {
      const glm::vec4 r((*m)[0][row], (*m)[1][row], (*m)[2][row], (*m)[3][row]);
      quadrics.push_back(bits(glm::vec3(r), std::bit_cast<std::uint32_t>(r.w)));
    }
  }
  const double inner = disk ? shape.inner_radius / shape.radius : 0;
  const auto inner2 = std::bit_cast<std::uint32_t>(static_cast<float>(inner * inner));
  quadrics.emplace_back(disk ? layout::kQuadricDisk : layout::kQuadricSphere, inner2, 0, 0);
  // Half extents of the image of the unit sphere (or disk) under the matrix: the norms of its rows.
  for (int row = 0; row < 3; ++row) {
    double squares = 0;
    for (int column = 0; column < (disk ? 2 : 3); ++column)
      squares += to_tree[column][row] * to_tree[column][row];
    const double centre = to_tree[3][row], half = std::sqrt(squares);
    const double rounding = 1e-5 * half + 1e-6 * std::abs(centre);  // the device tests quadrics in float
    box.low[row] = centre - half - rounding;
    box.high[row] = centre + half + rounding;
  }
}

/// The shape's place in Scene::shapes, or -1 for a shape of an object.
std::ptrdiff_t index_in_world(const Scene& scene, const Shape* shape) {
  const Shape* first = scene.shapes.data();
  return shape >= first && shape < first + scene.shapes.size() ? shape - first : -1;
}

/// What shading needs of a primitive, see Geometry::details.
void write_details(const Scene& scene, const Placed& placed, const DetailOptions& options,
                   std::size_t triangle, glm::uvec4* out) {
  const Shape& shape = *placed.shape;
  std::uint32_t light = layout::kNoLight;
  const std::ptrdiff_t at = options.light_words.empty() ? -1 : index_in_world(scene, &shape);
  if (at >= 0 && !options.light_words[at].empty()) {
    const auto& words = options.light_words[at];
    light = words.size() == 1 ? words[0] : words[triangle];
  }
  const std::uint32_t material =
      shape.material < 0 ? options.default_material : static_cast<std::uint32_t>(shape.material);
  std::fill(out, out + options.texels(), glm::uvec4(0));
  out[0] = glm::uvec4(light, 0, 0, material);
  if (shape.kind != ShapeKind::mesh) return;
  const TriangleMesh& mesh = scene.meshes[shape.mesh];
  const glm::uvec3 corners = mesh.triangles[triangle];
  if (options.normals && !mesh.normals.empty()) {
    const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(placed.to_tree)));
    glm::vec3 n[3];
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 v = turn * glm::dvec3(mesh.normals[corners[k]]);
      n[k] = glm::length(v) > 0 ? glm::normalize(v) : glm::dvec3(0);
    }
    out[0].y = std::bit_cast<std::uint32_t>(n[2].z);
    out[1] = bits(n[0], std::bit_cast<std::uint32_t>(n[2].x));
    out[2] = bits(n[1], std::bit_cast<std::uint32_t>(n[2].y));
  }
  if (options.uvs) {
    constexpr float kDefault[3][2] = {{0, 0}, {1, 0}, {1, 1}};  // pbrt's, of triangles without
    glm::uvec4* uvs = out + (options.normals ? 3 : 1);
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 2; ++c) {
        uvs[k / 2][2 * (k % 2) + c] =
            std::bit_cast<std::uint32_t>(mesh.uvs.empty() ? kDefault[k][c] : mesh.uvs[corners[k]][c]);
      }
    }
  }
}

/// The boxes of the tree's upper nodes.
std::vector<Box> upper_boxes(const BinaryTree& tree) {
  constexpr int kDepth = 5;
  std::vector<Box> boxes;
  std::vector<std::pair<std::uint32_t, int>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [n, depth] = stack.back();
    stack.pop_back();
    const BinaryNode& node = tree.nodes[n];
    if (depth == kDepth || node.count > 0) {
      boxes.push_back(node.box);
    } else {
      stack.emplace_back(node.first, depth + 1);
      stack.emplace_back(node.first + 1, depth + 1);
    }
  }
  return boxes;
}

}  // namespace

std::uint64_t primitive_count(const Scene& scene, const Shape& shape) {
  return shape.kind == ShapeKind::mesh ? scene.meshes[shape.mesh].triangles.size() : 1;
}

GeometryTree build_tree(const Scene& scene, std::span<const Placed> placed, const GeometryOptions& options,
                        std::vector<glm::uvec4>& quadrics) {
  std::vector<std::size_t> first(placed.size() + 1);
  for (std::size_t s = 0; s < placed.size(); ++s)
    first[s + 1] = first[s] + primitive_count(scene, *placed[s].shape);
  const std::size_t count = first.back();
  GeometryTree tree;
  if (count == 0) return tree;
  std::vector<Box> boxes(count);
  const std::size_t stride = options.details.texels();
  // Written by all threads below, each word once: to fill them with zeros here would take one thread as long.
  static_assert(std::is_trivially_default_constructible_v<glm::uvec4>);
  const auto texels = std::make_unique_for_overwrite<glm::uvec4[]>((3 + stride) * count);
  const std::span primitives(texels.get(), 3 * count), unsorted(texels.get() + 3 * count, stride * count);
  for (std::size_t s = 0; s < placed.size(); ++s) {
    if (placed[s].shape->kind == ShapeKind::mesh) continue;
    const auto id = layout::kQuadricBit | static_cast<std::uint32_t>(quadrics.size() / 7);
    add_quadric(placed[s], quadrics, boxes[first[s]]);
    primitives[3 * first[s]] = glm::uvec4(0, 0, 0, id);
    primitives[3 * first[s] + 1] = primitives[3 * first[s] + 2] = glm::uvec4(0);
    if (stride > 0) write_details(scene, placed[s], options.details, 0, &unsorted[stride * first[s]]);
  }
  struct Run {
    std::size_t shape, first, last;  ///< triangles first ... last - 1 of its mesh
  };
  constexpr std::size_t kRun = 1 << 14;
  std::vector<Run> runs;
  for (std::size_t s = 0; s < placed.size(); ++s) {
    if (placed[s].shape->kind != ShapeKind::mesh) continue;
    for (std::size_t t = 0; t < first[s + 1] - first[s]; t += kRun)
      runs.push_back({s, t, std::min(t + kRun, first[s + 1] - first[s])});
  }
  parallel_for(runs.size(), [&](std::size_t r) {
    const Run run = runs[r];
    const Placed& p = placed[run.shape];
    const TriangleMesh& mesh = scene.meshes[p.shape->mesh];
    for (std::size_t t = run.first; t < run.last; ++t) {
      const std::size_t at = first[run.shape] + t;
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec3 v = glm::dvec3(p.to_tree * glm::dvec4(mesh.positions[mesh.triangles[t][corner]], 1));
        boxes[at].add(glm::dvec3(v));
        primitives[3 * at + corner] = bits(v, corner == 0 ? p.first_id + static_cast<std::uint32_t>(t) : 0);
      }
      if (stride > 0) write_details(scene, p, options.details, t, &unsorted[stride * at]);
    }
  });
  {
    const BinaryTree binary =
        build_binary_tree(boxes, options.cut ? primitives : std::span<const glm::uvec4>());
    tree.boxes = upper_boxes(binary);
    std::vector<Box>().swap(boxes);
    tree.bvh = collapse(binary);
  }
  const std::size_t slots = tree.bvh.order.size();
  tree.primitives.resize(3 * slots);
  tree.details.resize(stride * slots);
  parallel_for(
      slots,
      [&](std::size_t slot) {
        const std::size_t from = tree.bvh.order[slot];
        for (int k = 0; k < 3; ++k) tree.primitives[3 * slot + k] = primitives[3 * from + k];
        for (std::size_t k = 0; k < stride; ++k)
          tree.details[stride * slot + k] = unsorted[stride * from + k];
      },
      1 << 14);
  return tree;
}

}  // namespace capcon
