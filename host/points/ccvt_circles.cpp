#include "points/ccvt_circles.h"

#include <algorithm>
#include <numeric>

#include "points/ccvt_cells.h"

namespace capcon {

namespace {

KdTree tree_of(const std::vector<CcvtCircle>& circles) {
  std::vector<glm::dvec2> centres;
  centres.reserve(circles.size());
  for (const CcvtCircle& c : circles) centres.emplace_back(c.centre.x, c.centre.y);
  std::vector<std::uint32_t> items(circles.size());
  std::iota(items.begin(), items.end(), 0u);
  return KdTree(centres, std::move(items));
}

/// How far p is from [low, high] on a circle of 2^32.
double gap(double p, double low, double high) {
  const double before = low - p, behind = p - high;
  if (before <= 0 && behind <= 0) return 0;
  return before > 0 ? std::min(before, behind + 0x1p32) : std::min(behind, before + 0x1p32);
}

}  // namespace

CcvtCircleTree::CcvtCircleTree(const std::vector<CcvtCircle>& circles, const std::vector<float>& slacks,
                               const std::vector<std::uint8_t>& seeks)
    : circles_(circles), slacks_(slacks), seeks_(seeks), tree_(tree_of(circles)) {
  const auto& nodes = tree_.nodes();
  seeking_.assign(nodes.size(), -1);
  waiting_.assign(nodes.size(), -1);
  for (std::size_t n = nodes.size(); n-- > 0;) {  // children come after their parents
    if (nodes[n].left != 0) {
      seeking_[n] = std::max(seeking_[nodes[n].left], seeking_[nodes[n].left + 1]);
      waiting_[n] = std::max(waiting_[nodes[n].left], waiting_[nodes[n].left + 1]);
      continue;
    }
    for (std::uint32_t k = nodes[n].first; k < nodes[n].first + nodes[n].count; ++k) {
      const std::uint32_t j = tree_.items()[k];
      float& most = seeks[j] ? seeking_[n] : waiting_[n];
      most = std::max(most, reach(j));
    }
  }
}

void CcvtCircleTree::overlaps(std::uint32_t i, const std::function<void(std::uint32_t)>& found) const {
  const TorusPoint centre = circles_[i].centre;
  const float own = reach(i);
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    const std::uint32_t n = stack.back();
    stack.pop_back();
    const KdTree::Node& node = tree_.nodes()[n];
    const double x = gap(centre.x, node.low.x, node.high.x), y = gap(centre.y, node.low.y, node.high.y);
    const double far = static_cast<double>(own) + std::max(waiting_[n], std::min(seeking_[n], own));
    if (x * x + y * y >= far * far * 1.000001) continue;
    if (node.left != 0) {
      stack.push_back(node.left);
      stack.push_back(node.left + 1);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t j = tree_.items()[k];
      const float other = reach(j);
      if (j == i || (seeks_[j] && (other > own || (other == own && j > i)))) continue;
      const auto dx = static_cast<float>(difference(circles_[j].centre.x, centre.x));
      const auto dy = static_cast<float>(difference(circles_[j].centre.y, centre.y));
      if (dx * dx + dy * dy < (own + other) * (own + other)) found(j);
    }
  }
}

}  // namespace capcon
