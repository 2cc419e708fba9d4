#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "scene/bvh.h"

namespace capcon {
namespace {

constexpr double kCells = 65535, kMiddle = 32768;
constexpr std::uint32_t kAbsent = 0xffffffff;
// Boxes grow by this much of a cell on every side before they are rounded outward: more than the device's
// rounding of a ray that starts within a few times the scene's size (shaders/tracing/ray.glsl).
constexpr double kMargin = 0.25;

struct Child {
  std::uint32_t node;  // of the binary tree
  bool inner;
};

struct Children {
  Child all[5];  // one more while a child is opened
  int count = 0;

  const Child* begin() const { return all; }
  const Child* end() const { return all + count; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(count); }
};

struct Pending {
  std::uint32_t binary;   // node of the binary tree
  std::uint32_t wide;     // where it goes
  std::uint32_t waiting;  // groups of siblings on the stack of a walk that comes here, at most
};

class Collapser {
 public:
  explicit Collapser(const BinaryTree& tree) : tree_(tree) {
    const Box& box = tree.nodes[0].box;
    const glm::dvec3 extent = box.high - box.low;
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-30});
    for (int a = 0; a < 3; ++a) {
      // Both rounded to float, as the device has them: the origin downwards, the scale so that the far end
      // still fits. Spare cells on either side take up the margin and the rounding.
      const double e = std::max(extent[a], largest * 1e-6);
      const double origin = box.low[a] - 2 * e / (kCells - 8);
      auto rounded = static_cast<float>(origin);
      if (rounded > origin) rounded = std::nextafter(rounded, -3e38f);
      bvh_.grid_origin[a] = rounded;
      bvh_.grid_scale[a] = static_cast<float>((kCells - 4) / (box.low[a] + e - rounded));
    }
    measure_promise();
    bvh_.texels.resize(4);
    bvh_.texels.reserve(tree.nodes.size());
    std::vector<Pending> stack{{0, 0, 0}};
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      emit(next, stack);
    }
    std::vector<double>().swap(promise_);
    parallel_for(
        bvh_.node_count(), [&](std::size_t n) { write_extents(&bvh_.texels[4 * n]); }, 1 << 12);
  }

  Bvh take() { return std::move(bvh_); }

 private:
  bool is_inner(std::uint32_t n) const { return tree_.nodes[n].count == 0; }

  /// For every node: the area of the leaves' boxes below it over the expected cost of a ray that meets its
  /// box (surface-area heuristic, a visit as much as a test).
  void measure_promise() {
    std::vector<double> surface(tree_.nodes.size()), cost(tree_.nodes.size());
    promise_.resize(tree_.nodes.size());
    for (std::size_t n = tree_.nodes.size(); n-- > 0;) {  // children come after their parents
      const BinaryNode& node = tree_.nodes[n];
      const double area = node.box.half_area();
      if (node.count > 0) {
        surface[n] = area;
        cost[n] = node.count;
      } else if (node.first > n) {
        cost[n] = 1;
        for (const std::uint32_t c : {node.first, node.first + 1}) {
          const double share = area > 0 ? tree_.nodes[c].box.half_area() / area : 1.0;
          cost[n] += cost[c] * share;
          surface[n] += surface[c];
        }
      }
      promise_[n] = surface[n] / cost[n];
    }
  }

  /// Up to four descendants of `binary`: the largest inner one is opened until there are four.
  Children children_of(std::uint32_t binary) const {
    Children children;
    const auto add = [&](std::uint32_t n) { children.all[children.count++] = {n, is_inner(n)}; };
    if (!is_inner(binary)) {
      add(binary);
      return children;
    }
    const auto open = [&](std::uint32_t n) {
      add(tree_.nodes[n].first);
      add(tree_.nodes[n].first + 1);
    };
    open(binary);
    while (children.count < 4) {
      int largest = -1;
      double area = -1;
      for (int c = 0; c < children.count; ++c) {
        const double own = children.all[c].inner ? tree_.nodes[children.all[c].node].box.half_area() : -2;
        if (own > area) area = own, largest = c;
      }
      if (largest < 0) break;
      const std::uint32_t opened = children.all[largest].node;
      std::copy(children.all + largest + 1, children.all + children.count, children.all + largest);
      --children.count;
      open(opened);
    }
    // Inner children first; among them first where most surface is met for least work: rays that ask for any
    // hit go through them in this order. Equal ones stay as they are.
    const auto before = [&](const Child& a, const Child& b) {
      return a.inner != b.inner ? a.inner : promise_[a.node] > promise_[b.node];
    };
    for (int i = 1; i < children.count; ++i) {
      for (int k = i; k > 0 && before(children.all[k], children.all[k - 1]); --k)
        std::swap(children.all[k], children.all[k - 1]);
    }
    return children;
  }

  /// Half extent and centre on an axis. The device takes the whole word for the centre, so that the half
  /// extent adds a fraction of a cell to it.
  std::uint32_t extent_word(const Box& box, int axis) const {
    const double scale = bvh_.grid_scale[axis], origin = bvh_.grid_origin[axis];
    const double low = (box.low[axis] - origin) * scale - kMargin - kMiddle;
    const double high = (box.high[axis] - origin) * scale + kMargin - kMiddle;
    const double centre = std::floor(0.5 * (low + high));
    double half = std::max(1.0, std::ceil(0.5 * (high - low)));
    while (centre + half / 65536 - half > low || centre + half / 65536 + half < high) half += 1;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(centre)) << 16 |
           static_cast<std::uint32_t>(half);
  }

  /// A node's links; its children's numbers in the binary tree stand in for their extents.
  void emit(Pending at, std::vector<Pending>& stack) {
    const Children children = children_of(at.binary);
    const auto inner = static_cast<std::uint32_t>(
        std::count_if(children.begin(), children.end(), [](auto& c) { return c.inner; }));
    const auto first_inner = static_cast<std::uint32_t>(bvh_.node_count());
    const auto first_slot = static_cast<std::uint32_t>(bvh_.order.size());
    bvh_.texels.resize(bvh_.texels.size() + 4 * inner);
    // A node with siblings that wait puts one entry under all that lies below it.
    const std::uint32_t below = at.waiting + (inner > 1 ? 1 : 0);
    bvh_.stack_entries = std::max(bvh_.stack_entries, below);
    glm::uvec4 numbers(kAbsent);
    std::array<std::uint32_t, 4> masks{};
    for (std::uint32_t c = 0; c < children.size(); ++c) {
      const BinaryNode& node = tree_.nodes[children.all[c].node];
      numbers[c] = children.all[c].node;
      if (children.all[c].inner) {
        stack.push_back({children.all[c].node, first_inner + c, below});
        continue;
      }
      const auto from = static_cast<std::uint32_t>(bvh_.order.size()) - first_slot;
      masks[c] = ((1u << node.count) - 1u) << from;
      bvh_.order.insert(bvh_.order.end(), tree_.order.begin() + node.first,
                        tree_.order.begin() + node.first + node.count);
    }
    bvh_.texels[4 * std::size_t(at.wide)] = numbers;
    bvh_.texels[4 * std::size_t(at.wide) + 3] = {first_inner << 4 | ((1u << inner) - 1u), first_slot,
                                                 masks[0] | masks[1] << 16, masks[2] | masks[3] << 16};
  }

  /// Extents of the children that emit() has named.
  void write_extents(glm::uvec4* node) const {
    const glm::uvec4 numbers = node[0];
    node[0] = node[1] = node[2] = glm::uvec4(0);
    for (int c = 0; c < 4; ++c) {
      if (numbers[c] == kAbsent) continue;
      for (int axis = 0; axis < 3; ++axis) node[axis][c] = extent_word(tree_.nodes[numbers[c]].box, axis);
    }
  }

  const BinaryTree& tree_;
  std::vector<double> promise_;  ///< by node of the binary tree
  Bvh bvh_;
};

}  // namespace

Bvh collapse(const BinaryTree& tree) {
  return Collapser(tree).take();
}

}  // namespace capcon
