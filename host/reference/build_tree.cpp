#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "reference/tree.h"

namespace capcon::reference {
namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kLeafSize = 4;
// From this depth on ranges are halved, which bounds the depth of the whole (and the stack of its traversal)
// by 48 + 32.
constexpr int kMaxSplitDepth = 48;

double half_area(const Box& box) {
  const glm::dvec3 d = glm::max(box.high - box.low, 0.0);
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

struct Split {
  int axis = -1;  ///< -1: no split is better than none
  int bin = 0;    ///< the first bin of the upper side
  double low = 0;
  double width = 0;

  int bin_of(const glm::dvec3& centre) const {
    return std::clamp(static_cast<int>((centre[axis] - low) / width), 0, kBins - 1);
  }
};

}  // namespace

class TreeBuilder {
 public:
  TreeBuilder(Tree& tree, const Primitives& primitives) : tree_(tree) {
    const std::uint32_t count = primitives.size();
    tree_.order_.resize(count);
    std::iota(tree_.order_.begin(), tree_.order_.end(), 0u);
    for (std::uint32_t i = 0; i < count; ++i) {
      boxes_.push_back(primitives.bounds(i));
      centres_.push_back(0.5 * (boxes_[i].low + boxes_[i].high));
    }
    tree_.nodes_.emplace_back();
    if (count > 0) build(0, 0, count, 0);
  }

 private:
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) box.grow(boxes_[tree_.order_[i]]);
    tree_.nodes_[node] = {box, begin, end - begin};
    if (end - begin <= kLeafSize) return;
    const std::uint32_t middle = partition(begin, end, depth);
    const auto children = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_[node].first = children;
    tree_.nodes_[node].count = 0;
    tree_.nodes_.resize(children + 2);
    build(children, begin, middle, depth + 1);
    build(children + 1, middle, end, depth + 1);
  }

  std::uint32_t partition(std::uint32_t begin, std::uint32_t end, int depth) {
    const auto first = tree_.order_.begin();
    const Split split = depth < kMaxSplitDepth ? choose(begin, end) : Split{};
    if (split.axis < 0) return begin + (end - begin) / 2;
    const auto upper = std::partition(first + begin, first + end, [&](std::uint32_t primitive) {
      return split.bin_of(centres_[primitive]) < split.bin;
    });
    return static_cast<std::uint32_t>(upper - first);
  }

  /// The cheapest of the planes between bins on each axis.
  Split choose(std::uint32_t begin, std::uint32_t end) const {
    Box spread;
    for (std::uint32_t i = begin; i < end; ++i) {
      const glm::dvec3& centre = centres_[tree_.order_[i]];
      spread.grow({centre, centre});
    }
    Split best;
    double best_cost = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
      Split split{axis, 0, spread.low[axis], (spread.high[axis] - spread.low[axis]) / kBins};
      if (!(split.width > 0)) continue;
      std::array<Box, kBins> boxes;
      std::array<std::uint32_t, kBins> counts{};
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t primitive = tree_.order_[i];
        const int bin = split.bin_of(centres_[primitive]);
        boxes[bin].grow(boxes_[primitive]);
        ++counts[bin];
      }
      std::array<double, kBins> upper_cost{};
      Box box;
      std::uint32_t count = 0;
      for (int bin = kBins - 1; bin > 0; --bin) {
        box.grow(boxes[bin]);
        count += counts[bin];
        upper_cost[bin] = count > 0 ? count * half_area(box) : 1e300;
      }
      box = {};
      count = 0;
      for (int bin = 1; bin < kBins; ++bin) {
        box.grow(boxes[bin - 1]);
        count += counts[bin - 1];
        const double cost = upper_cost[bin] + (count > 0 ? count * half_area(box) : 1e300);
        if (cost < best_cost) {
          best_cost = cost;
          best = split;
          best.bin = bin;
        }
      }
    }
    return best;
  }

  Tree& tree_;
  std::vector<Box> boxes_;
  std::vector<glm::dvec3> centres_;
};

Tree::Tree(const Primitives& primitives) : primitives_(primitives) {
  TreeBuilder(*this, primitives);
  if (order_.empty()) return;
  const glm::dvec3 reach = glm::max(glm::abs(nodes_[0].box.low), glm::abs(nodes_[0].box.high));
  scale_ = std::max({reach.x, reach.y, reach.z});
}

}  // namespace capcon::reference
