#include "reference/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace capcon::reference {
namespace {

/// What the box test needs of a ray, computed once.
/// Boxes are widened by a few ulps of the coordinates, the error of the triangle test.
struct Slabs {
  glm::dvec3 to_low;
  glm::dvec3 to_high;
  glm::dvec3 inverse;

  Slabs(const Ray& ray, double scale) {
    const glm::dvec3 size = glm::abs(ray.origin);
    const double margin = 0x1p-48 * std::max({size.x, size.y, size.z, scale});
    to_low = ray.origin + margin;
    to_high = ray.origin - margin;
    for (int axis = 0; axis < 3; ++axis) {
      // A tiny number instead of 0 keeps 0 * infinity out of the test below.
      const double d = ray.direction[axis];
      inverse[axis] = 1 / (std::abs(d) < 1e-300 ? std::copysign(1e-300, d) : d);
    }
  }

  /// Where the ray enters the box, or infinity when it misses it within [0, t_max]. The far end is widened by
  /// the error of the arithmetic (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013), so that nothing inside
  /// is missed.
  double enter(const Box& box, double t_max) const {
    double near = 0;
    double far = t_max;
    for (int axis = 0; axis < 3; ++axis) {
      double t0 = (box.low[axis] - to_low[axis]) * inverse[axis];
      double t1 = (box.high[axis] - to_high[axis]) * inverse[axis];
      if (t0 > t1) std::swap(t0, t1);
      t1 *= 1 + 0x1p-49;
      near = t0 > near ? t0 : near;
      far = t1 < far ? t1 : far;
    }
    return near <= far ? near : std::numeric_limits<double>::infinity();
  }
};

}  // namespace

template <typename Visit>
void Tree::walk(const Ray& ray, double& t_max, const Visit& visit) const {
  if (order_.empty()) return;
  constexpr double kMissed = std::numeric_limits<double>::infinity();
  struct Entry {
    std::uint32_t node;
    double enter;
  };
  std::array<Entry, 96> stack;  // deeper than any tree that TreeBuilder makes
  int size = 0;
  const Slabs slabs(ray, scale_);
  Entry here{0, slabs.enter(nodes_[0].box, t_max)};
  if (here.enter == kMissed) return;
  for (;;) {
    const Node& node = nodes_[here.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (visit(order_[i])) return;
    }
    if (node.count == 0) {
      Entry a{node.first, slabs.enter(nodes_[node.first].box, t_max)};
      Entry b{node.first + 1, slabs.enter(nodes_[node.first + 1].box, t_max)};
      if (b.enter < a.enter) std::swap(a, b);
      if (b.enter != kMissed) stack[size++] = b;
      if (a.enter != kMissed) {
        here = a;
        continue;
      }
    }
    do {
      if (size == 0) return;
      here = stack[--size];
    } while (here.enter > t_max);
  }
}

std::optional<Hit> Tree::closest(const Ray& ray, const Ignored& ignored, double t_max) const {
  std::optional<Hit> nearest;
  walk(ray, t_max, [&](std::uint32_t primitive) {
    if (ignored(primitive)) return false;
    const double t = primitives_.intersect(primitive, ray, t_max);
    // Of two primitives at the same distance the lower number wins, whatever the order of the tree.
    if (t > 0 && (!nearest || t < nearest->t || (t == nearest->t && primitive < nearest->primitive))) {
      nearest = {primitive, t};
      t_max = t;
    }
    return false;
  });
  return nearest;
}

bool Tree::occluded(const Ray& ray, double t_max, const Ignored& ignored) const {
  bool hit = false;
  walk(ray, t_max, [&](std::uint32_t primitive) {
    hit = !ignored(primitive) && primitives_.intersect(primitive, ray, t_max) > 0;
    return hit;
  });
  return hit;
}

}  // namespace capcon::reference
