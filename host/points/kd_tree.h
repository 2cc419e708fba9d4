#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// A balanced tree of boxes over points in the plane, for nearest-first walks.
class KdTree {
 public:
  struct Node {
    glm::dvec2 low, high;        ///< bounding box of the points below
    std::uint32_t first, count;  ///< items()[first, first + count)
    std::uint32_t left = 0;      ///< children are left and left + 1; 0 in a leaf
  };
  /// An element of a walk's queue: a node of a periodic image, and its squared distance.
  struct Entry {
    double distance2;
    std::uint32_t node;
    glm::dvec2 shift;
  };

  KdTree() = default;
  /// Over points[item] for the given items.
  KdTree(const std::vector<glm::dvec2>& points, std::vector<std::uint32_t> items);

  bool empty() const { return nodes_.empty(); }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<std::uint32_t>& items() const { return items_; }

 private:
  std::vector<Node> nodes_;  ///< the root is nodes_[0]
  std::vector<std::uint32_t> items_;
};

/// Squared distance from p to the box [low, high].
double box_distance2(glm::dvec2 p, glm::dvec2 low, glm::dvec2 high);

}  // namespace capcon
