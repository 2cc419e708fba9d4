#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "reference/primitives.h"

namespace capcon::reference {

struct Hit {
  std::uint32_t primitive = 0;
  double t = 0;
};

/// Primitives that a ray is not tested against: one, and `count` from `first` on.
struct Ignored {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t primitive = kNone;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  bool operator()(std::uint32_t number) const { return number == primitive || number - first < count; }
};

/// A binary bounding volume hierarchy over primitives, split by the surface area heuristic over bins.
class Tree {
 public:
  /// Keeps a reference to `primitives`.
  explicit Tree(const Primitives& primitives);

  /// The nearest surface in front of the origin, at a distance in (0, t_max].
  std::optional<Hit> closest(const Ray& ray, const Ignored& ignored = {},
                             double t_max = std::numeric_limits<double>::infinity()) const;
  /// Whether anything that is not ignored is hit at a distance in (0, t_max].
  bool occluded(const Ray& ray, double t_max, const Ignored& ignored = {}) const;
  /// Largest magnitude of a coordinate in the scene.
  double scale() const { return scale_; }

 private:
  /// Inner nodes (count 0) have their children at `first` and `first + 1`; leaves hold order_[first .. first
  /// + count).
  struct Node {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  /// Visits the leaves that the ray may touch, nearer ones first, until visit(primitive) returns true; the
  /// visitor may lower t_max.
  template <typename Visit>
  void walk(const Ray& ray, double& t_max, const Visit& visit) const;

  const Primitives& primitives_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  double scale_ = 0;
  friend class TreeBuilder;
};

}  // namespace capcon::reference
