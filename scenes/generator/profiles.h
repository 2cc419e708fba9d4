#pragma once

#include <vector>

#include "generator/mesh.h"

namespace capcon::scenes {

/// A profile drawn like a mason's template: every call continues from the last point.
class Profile {
 public:
  Profile(double x, double y) : points_{{x, y}} {}
  Profile& to(double x, double y);
  Profile& by(double dx, double dy);
  /// A curve to a point `dx`, `dy` away. bulge > 0: a torus or ovolo to the right of the way, < 0: a hollow;
  /// 1 is a half circle's.
  Profile& curve(double dx, double dy, double bulge, int segments);
  const std::vector<Vec2>& points() const { return points_; }

 private:
  std::vector<Vec2> points_;
};

/// A smooth curve (Catmull-Rom) through the points, `segments` a span.
std::vector<Vec2> smooth(const std::vector<Vec2>& points, int segments);
std::vector<Vec3> smooth(const std::vector<Vec3>& points, int segments);

/// Random numbers by address: the value number (i, k) of one stream.
class Dice {
 public:
  explicit Dice(std::uint64_t stream) : stream_(stream) {}
  double between(double low, double high, std::uint64_t i, std::uint64_t k = 0) const;

 private:
  std::uint64_t stream_;
};

}  // namespace capcon::scenes
