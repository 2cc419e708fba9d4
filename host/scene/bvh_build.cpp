#include <algorithm>
#include <array>
#include <future>

#include "base/parallel.h"
#include "scene/bvh.h"

namespace capcon {

double Box::half_area() const {
  const glm::dvec3 d = high - low;
  return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kLeafSize = 4;
// Costs relative to one primitive test: a visit of a wide node, shared by its children.
constexpr double kVisitCost = 1.0;
constexpr std::size_t kParallelSize = 1 << 14;  // smaller ranges are not worth a thread

struct FloatBox {
  float low[3], high[3];
};

struct Bin {
  float low[3] = {3e38f, 3e38f, 3e38f};
  float high[3] = {-3e38f, -3e38f, -3e38f};
  std::uint32_t count = 0;

  void add(const FloatBox& b) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], b.low[a]);
      high[a] = std::max(high[a], b.high[a]);
    }
    ++count;
  }
  void add(const Bin& b) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], b.low[a]);
      high[a] = std::max(high[a], b.high[a]);
    }
    count += b.count;
  }
  double half_area() const {
    if (count == 0) return 0;
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

struct Split {
  int axis = -1;
  int bin = 0;
  double cost = 1e300;
  float origin = 0, scale = 0;
};

class Builder {
 public:
  explicit Builder(std::span<const Box> boxes) : boxes_(boxes), small_(boxes.size()), entries_(boxes.size()) {
    parallel_for(
        boxes.size(),
        [&](std::size_t i) {
          for (int a = 0; a < 3; ++a) {
            small_[i].low[a] = static_cast<float>(boxes[i].low[a]);
            small_[i].high[a] = static_cast<float>(boxes[i].high[a]);
          }
          entries_[i] = static_cast<std::uint32_t>(i);
        },
        1 << 14);
    tree_.nodes.resize(2 * boxes.size());
    int depth = 0;
    while ((1u << depth) < 2 * thread_count()) ++depth;
    build(0, 1, 0, boxes.size(), depth);
    tree_.order = std::move(entries_);
  }

  BinaryTree take() { return std::move(tree_); }

 private:
  float centre(std::uint32_t i, int axis) const {
    return 0.5f * (small_[i].low[axis] + small_[i].high[axis]);
  }

  /// Builds node `at` over entries [begin, end). Its descendants take nodes from `free` on: 2 (end - begin) -
  /// 2 of them, so that no two threads ever write to the same place and the layout does not depend on their
  /// number.
  void build(std::size_t at, std::size_t free, std::size_t begin, std::size_t end, int parallel_depth) {
    BinaryNode& node = tree_.nodes[at];
    Bin bounds, centres;
    for (std::size_t k = begin; k < end; ++k) {
      const FloatBox& b = small_[entries_[k]];
      bounds.add(b);
      FloatBox c;
      for (int a = 0; a < 3; ++a) c.low[a] = c.high[a] = 0.5f * (b.low[a] + b.high[a]);
      centres.add(c);
    }
    const std::size_t count = end - begin;
    const Split split = count > 1 ? best_split(begin, end, centres, bounds.half_area()) : Split{};
    if (count <= kLeafSize && (split.axis < 0 || split.cost >= static_cast<double>(count))) {
      make_leaf(node, begin, end);
      return;
    }
    std::size_t middle = begin + count / 2;
    if (split.axis >= 0) {
      const auto left = [&](std::uint32_t i) { return bin_of(i, split) <= split.bin; };
      middle =
          std::stable_partition(entries_.begin() + begin, entries_.begin() + end, left) - entries_.begin();
    }  // else all centres coincide: halves by order
    node.first = static_cast<std::uint32_t>(free);
    node.count = 0;
    const std::size_t left_free = free + 2;
    const std::size_t right_free = left_free + 2 * (middle - begin) - 2;
    if (parallel_depth > 0 && count > kParallelSize) {
      auto left =
          std::async(std::launch::async, [&] { build(free, left_free, begin, middle, parallel_depth - 1); });
      build(free + 1, right_free, middle, end, parallel_depth - 1);
      left.get();
    } else {
      build(free, left_free, begin, middle, 0);
      build(free + 1, right_free, middle, end, 0);
    }
    node.box = tree_.nodes[free].box;
    node.box.add(tree_.nodes[free + 1].box);
  }

  void make_leaf(BinaryNode& node, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) node.box.add(boxes_[entries_[k]]);
    node.first = static_cast<std::uint32_t>(begin);
    node.count = static_cast<std::uint32_t>(end - begin);
  }

  int bin_of(std::uint32_t i, const Split& s) const {
    return std::min(kBins - 1, static_cast<int>((centre(i, s.axis) - s.origin) * s.scale));
  }

  Split best_split(std::size_t begin, std::size_t end, const Bin& centres, double area) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centres.high[axis] - centres.low[axis];
      if (!(extent > 0)) continue;
      Split split{axis, 0, 0, centres.low[axis], kBins / extent};
      if (!(split.scale < 3e38f)) continue;  // the centres differ by less than a float can bin
      std::array<Bin, kBins> bins;
      for (std::size_t k = begin; k < end; ++k) bins[bin_of(entries_[k], split)].add(small_[entries_[k]]);
      std::array<double, kBins> right_cost{};
      Bin right;
      for (int b = kBins - 1; b > 0; --b) {
        right.add(bins[b]);
        right_cost[b] = right.half_area() * right.count;
      }
      Bin left;
      for (int b = 0; b + 1 < kBins; ++b) {
        left.add(bins[b]);
        if (left.count == 0 || left.count == end - begin) continue;
        split.bin = b;
        const double cost = left.half_area() * left.count + right_cost[b + 1];
        split.cost = kVisitCost + (area > 0 ? cost / area : static_cast<double>(end - begin) * 0.5);
        if (split.cost < best.cost) best = split;
      }
    }
    return best;
  }

  std::span<const Box> boxes_;
  std::vector<FloatBox> small_;
  std::vector<std::uint32_t> entries_;
  BinaryTree tree_;
};

}  // namespace

BinaryTree build_binary_tree(std::span<const Box> boxes) {
  return Builder(boxes).take();
}

}  // namespace capcon
