#include <algorithm>
#include <future>
#include <memory>
#include <utility>
#include <vector>

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

/// A tree in pieces, each built by a thread: parts below node `at` lie in another one, in the order in which
/// one thread would have built them.
struct Piece {
  BinaryTree tree;
  struct Part {
    std::size_t at;
    std::unique_ptr<Piece> piece;
  };
  std::vector<Part> parts;
};

/// Where a piece's nodes but the first, and its leaves' primitives, go in the whole tree.
struct Place {
  const Piece* piece;
  std::size_t root, nodes, order;
};

/// The whole tree, copied once by all threads. Node for node the one that a single thread builds.
BinaryTree join(Piece first) {
  std::vector<Place> places;
  std::size_t nodes = 0, order = 0;
  const auto place = [&](const Piece& piece, std::size_t root, const auto& self) -> void {
    const std::size_t before = nodes;  // of the piece's node 1
    places.push_back({&piece, root, before, order});
    nodes += piece.tree.nodes.size() - 1;
    order += piece.tree.order.size();
    for (const Piece::Part& part : piece.parts) self(*part.piece, before + part.at - 1, self);
  };
  nodes = 1;
  place(first, 0, place);
  BinaryTree whole;
  if (places.size() == 1) return std::move(first.tree);
  whole.nodes.resize(nodes);
  whole.order.resize(order);
  const auto moved = [](const Place& p, std::size_t n) {
    BinaryNode node = p.piece->tree.nodes[n];
    node.first += static_cast<std::uint32_t>(node.count > 0 ? p.order : p.nodes - 1);
    return node;
  };
  parallel_for(places.size(), [&](std::size_t k) {
    const Place& p = places[k];
    const BinaryTree& part = p.piece->tree;
    for (std::size_t n = 1; n < part.nodes.size(); ++n) whole.nodes[p.nodes + n - 1] = moved(p, n);
    std::copy(part.order.begin(), part.order.end(),
              whole.order.begin() + static_cast<std::ptrdiff_t>(p.order));
  });
  // Last, as the piece above has an empty node there.
  for (const Place& p : places) whole.nodes[p.root] = moved(p, 0);
  return whole;
}

class Builder {
 public:
  Builder(const Cutter& cutter, double root_area, double primitive_cost)
      : cutter_(cutter), root_area_(root_area), visit_cost_(kVisitCost / primitive_cost) {}

  /// Builds node `at` of `piece` over the references; its descendants are appended. `spare`: how many
  /// references may be added below. Above `parallel_depth` 0 large right halves become pieces of their own.
  void build(Piece& piece, std::size_t at, std::span<Reference> references, std::size_t spare,
             int parallel_depth) const {
    BinaryTree& tree = piece.tree;
    const auto [box, centres] = bounds_of(references);
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
      auto other = std::make_unique<Piece>();
      other->tree.nodes.resize(1);
      auto job = std::async(std::launch::async,
                            [&] { build(*other, 0, right, spare - left_spare, parallel_depth - 1); });
      build(piece, first, left, left_spare, parallel_depth - 1);
      job.get();
      piece.parts.push_back({first + 1, std::move(other)});
    } else {
      build(piece, first, left, left_spare, 0);
      build(piece, first + 1, right, spare - left_spare, 0);
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
  const FloatBox all = bounds_of(references).box;
  const Cutter cutter(triangles);
  const auto spare =
      cutter.empty() ? 0 : static_cast<std::size_t>(kSpareReferences * static_cast<double>(boxes.size()));
  int depth = 0;
  while ((1u << depth) < 2 * thread_count()) ++depth;
  Piece tree;
  tree.tree.nodes.resize(1);
  Builder(cutter, all.half_area(), primitive_cost).build(tree, 0, references, spare, depth);
  std::vector<Reference>().swap(references);
  return join(std::move(tree));
}

}  // namespace capcon
