#include <algorithm>
#include <future>

#include "base/parallel.h"
#include "scene/bvh.h"
#include "scene/bvh_split.h"

namespace capcon {

double Box::half_area() const {
  const glm::dvec3 d = high - low;
  return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

namespace {

constexpr std::size_t kLeafSize = 4;
// A visit of a node relative to one primitive test, by the times that both take on lavapipe.
constexpr double kVisitCost = 2;
constexpr std::size_t kParallelSize = 1 << 14;  // smaller ranges are not worth a thread
// Spatial splits are tried where the halves of the object split overlap by this much of the root's area, and
// of the node's own.
constexpr double kRootOverlap = 1e-3, kOwnOverlap = 0.01;
constexpr double kSpareReferences = 0.3;  // at most so many more, relative to the primitives

Box to_box(const FloatBox& f) {
  return {{f.low[0], f.low[1], f.low[2]}, {f.high[0], f.high[1], f.high[2]}};
}

double overlap(const FloatBox& a, const FloatBox& b) {
  FloatBox o;
  for (int k = 0; k < 3; ++k) {
    o.low[k] = std::max(a.low[k], b.low[k]);
    o.high[k] = std::min(a.high[k], b.high[k]);
  }
  return o.half_area();
}

class Builder {
 public:
  Builder(const Cutter& cutter, double root_area, double primitive_cost)
      : cutter_(cutter), root_area_(root_area), visit_cost_(kVisitCost / primitive_cost) {}

  /// Builds node `at` of `tree` over the references; its descendants are appended in an order that does not
  /// depend on the number of threads. `spare`: how many references may be added below.
  void build(BinaryTree& tree, std::size_t at, std::span<Reference> references, std::size_t spare,
             int parallel_depth) const {
    FloatBox box, centres;
    for (const Reference& r : references) {
      box.add(r);
      const float c[3] = {r.centre(0), r.centre(1), r.centre(2)};
      for (int a = 0; a < 3; ++a) {
        centres.low[a] = std::min(centres.low[a], c[a]);
        centres.high[a] = std::max(centres.high[a], c[a]);
      }
    }
    tree.nodes[at].box = to_box(box);
    const std::size_t count = references.size();
    const Split object = count > 1 ? best_object_split(references, centres) : Split{};
    Split spatial;
    if (spare > 0 && object.axis >= 0) {
      const double shared = overlap(object.left, object.right);
      if (shared > kRootOverlap * root_area_ && shared > kOwnOverlap * box.half_area()) {
        spatial = best_spatial_split(references, box, spare, cutter_);
      }
    }
    const double area = box.half_area(), best = std::min(object.cost, spatial.cost);
    const double cost = visit_cost_ + (area > 0 ? best / area : 0.5 * static_cast<double>(count));
    if (count <= kLeafSize && (object.axis < 0 || cost >= static_cast<double>(count))) {
      make_leaf(tree, at, references);
      return;
    }
    std::vector<Reference> left_parts, right_parts;
    if (spatial.cost < object.cost) divide_space(references, spatial, left_parts, right_parts);
    std::span<Reference> left(left_parts), right(right_parts);
    // Objects are divided in place; so is a cut that rounding leaves without use: all on one side, or nothing
    // gained.
    if (left.empty() || right.empty() || left.size() >= count || right.size() >= count) {
      const std::size_t middle = divide_objects(references, object);
      left = references.first(middle);
      right = references.subspan(middle);
    }
    spare -= std::min(spare, left.size() + right.size() - count);
    const std::size_t left_spare = spare * left.size() / (left.size() + right.size());

    const std::size_t first = tree.nodes.size();
    tree.nodes[at].first = static_cast<std::uint32_t>(first);
    tree.nodes.resize(first + 2);
    if (parallel_depth > 0 && count > kParallelSize) {
      BinaryTree other;
      other.nodes.resize(1);
      auto job = std::async(std::launch::async,
                            [&] { build(other, 0, right, spare - left_spare, parallel_depth - 1); });
      build(tree, first, left, left_spare, parallel_depth - 1);
      job.get();
      graft(tree, first + 1, other);
    } else {
      build(tree, first, left, left_spare, 0);
      build(tree, first + 1, right, spare - left_spare, 0);
    }
  }

 private:
  /// A leaf holds no primitive twice, even where several of its parts came together.
  static void make_leaf(BinaryTree& tree, std::size_t at, std::span<const Reference> references) {
    BinaryNode& node = tree.nodes[at];
    node.first = static_cast<std::uint32_t>(tree.order.size());
    for (const Reference& r : references) {
      const auto begin = tree.order.begin() + node.first;
      if (std::find(begin, tree.order.end(), r.primitive) == tree.order.end())
        tree.order.push_back(r.primitive);
    }
    node.count = static_cast<std::uint32_t>(tree.order.size()) - node.first;
  }

  /// Puts what goes left in front; returns how many these are.
  static std::size_t divide_objects(std::span<Reference> references, const Split& split) {
    if (split.axis < 0) return references.size() / 2;
    const auto middle = std::partition(references.begin(), references.end(), [&](const Reference& r) {
      return split.bins.of(r.centre(split.axis)) < split.bin;
    });
    return static_cast<std::size_t>(middle - references.begin());
  }

  /// What lies across the plane is cut, or goes to one side whole where that is cheaper.
  void divide_space(std::span<const Reference> references, const Split& split, std::vector<Reference>& left,
                    std::vector<Reference>& right) const {
    const double left_cost = split.left.half_area(), right_cost = split.right.half_area();
    const double cut_cost = left_cost * split.left_count + right_cost * split.right_count;
    for (const Reference& r : references) {
      if (r.high[split.axis] <= split.plane || r.low[split.axis] >= split.plane) {
        (r.high[split.axis] <= split.plane ? left : right).push_back(r);
        continue;
      }
      FloatBox with_left = split.left, with_right = split.right;
      with_left.add(r);
      with_right.add(r);
      const double as_left =
          with_left.half_area() * split.left_count + right_cost * (split.right_count - 1.0);
      const double as_right =
          left_cost * (split.left_count - 1.0) + with_right.half_area() * split.right_count;
      Reference low, high;
      const bool whole = std::min(as_left, as_right) < cut_cost;
      const bool has_low = !whole && cutter_.cut(r, split.axis, r.low[split.axis], split.plane, low);
      const bool has_high = !whole && cutter_.cut(r, split.axis, split.plane, r.high[split.axis], high);
      if (has_low) left.push_back(low);
      if (has_high) right.push_back(high);
      if (!has_low && !has_high) (as_left <= as_right ? left : right).push_back(r);
    }
  }

  /// Appends a tree that was built apart; its root becomes node `at`.
  static void graft(BinaryTree& tree, std::size_t at, const BinaryTree& other) {
    const auto node_base = static_cast<std::uint32_t>(tree.nodes.size()) - 1;
    const auto order_base = static_cast<std::uint32_t>(tree.order.size());
    const auto moved = [&](BinaryNode node) {
      node.first += node.count > 0 ? order_base : node_base;
      return node;
    };
    tree.nodes[at] = moved(other.nodes[0]);
    for (std::size_t n = 1; n < other.nodes.size(); ++n) tree.nodes.push_back(moved(other.nodes[n]));
    tree.order.insert(tree.order.end(), other.order.begin(), other.order.end());
  }

  const Cutter& cutter_;
  double root_area_;
  double visit_cost_;  ///< of a node, in tests of a primitive
};

}  // namespace

BinaryTree build_binary_tree(std::span<const Box> boxes, std::span<const glm::uvec4> triangles,
                             double primitive_cost) {
  std::vector<Reference> references(boxes.size());
  parallel_for(
      boxes.size(),
      [&](std::size_t i) { references[i] = make_reference(boxes[i], static_cast<std::uint32_t>(i)); },
      1 << 14);
  FloatBox all;
  for (const Reference& r : references) all.add(r);
  const Cutter cutter(triangles);
  const auto spare =
      cutter.empty() ? 0 : static_cast<std::size_t>(kSpareReferences * static_cast<double>(boxes.size()));
  int depth = 0;
  while ((1u << depth) < 2 * thread_count()) ++depth;
  BinaryTree tree;
  tree.nodes.resize(1);
  tree.nodes.reserve(boxes.size());
  Builder(cutter, all.half_area(), primitive_cost).build(tree, 0, references, spare, depth);
  return tree;
}

}  // namespace capcon
