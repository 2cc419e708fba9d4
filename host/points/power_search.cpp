#include "points/power_search.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace capcon {

namespace {

KdTree tree_of(std::span<const glm::dvec2> sites) {
  std::vector<std::uint32_t> items(sites.size());
  std::iota(items.begin(), items.end(), 0u);
  return KdTree({sites.begin(), sites.end()}, std::move(items));
}

}  // namespace

PowerSearch::PowerSearch(std::span<const glm::dvec2> sites, std::span<const double> weights)
    : sites_(sites), weights_(weights), tree_(tree_of(sites)) {
  const auto& nodes = tree_.nodes();
  heaviest_.assign(nodes.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t n = nodes.size(); n-- > 0;) {  // children come after their parents
    if (nodes[n].left != 0) {
      heaviest_[n] = std::max(heaviest_[nodes[n].left], heaviest_[nodes[n].left + 1]);
      continue;
    }
    for (std::uint32_t k = nodes[n].first; k < nodes[n].first + nodes[n].count; ++k) {
      heaviest_[n] = std::max(heaviest_[n], weights[tree_.items()[k]]);
    }
  }
}

void PowerSearch::cut(std::uint32_t i, PowerCell& cell, std::vector<KdTree::Entry>& queue) const {
  const glm::dvec2 site = sites_[i];
  const auto later = [](const KdTree::Entry& a, const KdTree::Entry& b) {
    return a.distance2 != b.distance2 ? a.distance2 > b.distance2 : a.node > b.node;
  };
  // A site of the box can win a corner c only with |c - box|^2 - heaviest < |c|^2 - own weight.
  const auto reaches = [&](glm::dvec2 low, glm::dvec2 high, double heaviest) {
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const glm::dvec2 c = cell.corner(k);
      if (box_distance2(c, low, high) - heaviest < glm::dot(c, c) - weights_[i]) return true;
    }
    return false;
  };
  const auto push = [&](std::uint32_t n, glm::dvec2 shift) {
    const KdTree::Node& node = tree_.nodes()[n];
    const glm::dvec2 low = (node.low - site) + shift, high = (node.high - site) + shift;
    if (!reaches(low, high, heaviest_[n])) return;
    queue.push_back({box_distance2(glm::dvec2(0), low, high) - heaviest_[n], n, shift});
    std::push_heap(queue.begin(), queue.end(), later);
  };
  queue.clear();
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) push(0, {x, y});
  }
  while (!queue.empty() && !cell.empty()) {
    std::pop_heap(queue.begin(), queue.end(), later);
    const KdTree::Entry entry = queue.back();
    queue.pop_back();
    const KdTree::Node& node = tree_.nodes()[entry.node];
    if (!reaches((node.low - site) + entry.shift, (node.high - site) + entry.shift, heaviest_[entry.node]))
      continue;
    if (node.left != 0) {
      push(node.left, entry.shift);
      push(node.left + 1, entry.shift);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t j = tree_.items()[k];
      if (j == i) continue;  // the unit square knows of its own images
      const glm::dvec2 d = (sites_[j] - site) + entry.shift;
      cell.cut(d, 0.5 * (glm::dot(d, d) + weights_[i] - weights_[j]),
               {j, static_cast<int>(entry.shift.x), static_cast<int>(entry.shift.y)});
    }
  }
}

}  // namespace capcon
