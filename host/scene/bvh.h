#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace capcon {

/// An axis-aligned box, in double so that rounding to the grid is outward for sure.
struct Box {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};

  void add(const Box& b) {
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
  }
  void add(glm::dvec3 p) { add(Box{p, p}); }
  /// Half the surface; 0 for an empty box.
  double half_area() const;
};

/// A node of the binary tree that the builder makes: inner nodes have `count` 0 and children at `first` and
/// `first + 1`; leaves hold the primitives order[first ... first + count - 1].
struct BinaryNode {
  Box box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct BinaryTree {
  std::vector<BinaryNode> nodes;     ///< root at 0; siblings side by side, after their parent
  std::vector<std::uint32_t> order;  ///< primitive indices in leaf order; with spatial splits some come twice
};

/// Surface-area heuristic over 32 bins an axis (Wald 2007), leaves of at most 4, all threads; the same tree
/// for any number of them. At least one box. With `triangles` (three texels a primitive, see
/// Geometry::primitives) primitives that lie across the best plane may be cut by it (spatial splits, Stich et
/// al. 2009): then `order` names some of them in several leaves, at most 1.3 times as many entries as
/// primitives. `primitive_cost`: of testing one, relative to a triangle; above 0.
BinaryTree build_binary_tree(std::span<const Box> boxes, std::span<const glm::uvec4> triangles = {},
                             double primitive_cost = 1);

/// The tree that the device walks: four children a node, in 64 bytes.
///   word  0- 3   x extents of children 0-3: half extent | centre << 16, in grid coordinates; the centre is
///                signed, counted from the grid's middle, and what the word's low half adds to it is allowed
///                for
///   word  4-11   y extents, z extents
///   word 12      index of the first inner child << 4 | mask of inner children (they are first and
///   contiguous) word 13      slot of the first primitive of this node's leaves word 14, 15  masks of each
///   child's primitives, counted from that slot: child 0 | child 1 << 16, child 2 | child 3 << 16
/// An absent child has neither its inner bit nor primitives; whether its box is met does not matter.
struct Bvh {
  glm::dvec3 grid_origin{0};
  glm::dvec3 grid_scale{1};          ///< grid coordinates = (p - origin) * scale, 0 ... 65535
  std::vector<glm::uvec4> texels;    ///< four a node
  std::vector<std::uint32_t> order;  ///< primitive indices in slot order; with spatial splits some come twice
  std::uint32_t stack_entries = 1;   ///< most groups of siblings that wait at once
  std::size_t node_count() const { return texels.size() / 4; }
};

/// Collapses a binary tree greedily by area and quantises the boxes to one grid of 16 bits an axis.
Bvh collapse(const BinaryTree& tree);

inline Bvh build_bvh(std::span<const Box> boxes, double primitive_cost = 1) {
  return collapse(build_binary_tree(boxes, {}, primitive_cost));
}

}  // namespace capcon
