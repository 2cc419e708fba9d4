#include "points/kd_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace capcon {

KdTree::KdTree(const std::vector<glm::dvec2>& points, std::vector<std::uint32_t> items)
    : items_(std::move(items)) {
  constexpr std::uint32_t kLeaf = 6;
  if (items_.empty()) return;
  nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(items_.size())});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {  // breadth first: children are appended
    Node node = nodes_[n];
    const auto begin = items_.begin() + node.first;
    node.low = node.high = points[*begin];
    for (auto item = begin; item != begin + node.count; ++item) {
      node.low = glm::min(node.low, points[*item]);
      node.high = glm::max(node.high, points[*item]);
    }
    if (node.count > kLeaf) {
      const int axis = node.high.y - node.low.y > node.high.x - node.low.x ? 1 : 0;
      const std::uint32_t half = node.count / 2;
      std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t a, std::uint32_t b) {
        return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
      });
      node.left = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({{}, {}, node.first, half});
      nodes_.push_back({{}, {}, node.first + half, node.count - half});
    }
    nodes_[n] = node;
  }
}

double box_distance2(glm::dvec2 p, glm::dvec2 low, glm::dvec2 high) {
  const glm::dvec2 d = p - glm::clamp(p, low, high);
  return glm::dot(d, d);
}

}  // namespace capcon
