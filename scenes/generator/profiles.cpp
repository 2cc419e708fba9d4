#include "generator/profiles.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/hash.h"

namespace capcon::scenes {

Profile& Profile::to(double x, double y) {
  points_.emplace_back(x, y);
  return *this;
}

Profile& Profile::by(double dx, double dy) {
  return to(points_.back().x + dx, points_.back().y + dy);
}

Profile& Profile::curve(double dx, double dy, double bulge, int segments) {
  // A circular arc over the chord; its half angle is 4 atan(bulge) / 2 as in drawing programs.
  const Vec2 start = points_.back(), chord(dx, dy);
  const double half = 2 * std::atan(std::abs(bulge));
  const double radius = 0.5 * glm::length(chord) / std::sin(half);
  const Vec2 side = Vec2(dy, -dx) / glm::length(chord) * (bulge < 0 ? -1.0 : 1.0);
  const Vec2 along = chord / glm::length(chord);
  const Vec2 centre = start + 0.5 * chord - side * (radius * std::cos(half));
  for (int i = 1; i <= segments; ++i) {
    const double angle = -half + 2 * half * i / segments;
    points_.push_back(centre + radius * (std::sin(angle) * along + std::cos(angle) * side));
  }
  points_.back() = start + chord;
  return *this;
}

namespace {
template <class V>
std::vector<V> catmull_rom(const std::vector<V>& points, int segments) {
  std::vector<V> curve;
  const auto at = [&](std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
    if (i < 0) return 2.0 * points[0] - points[1];
    if (i > last) return 2.0 * points[last] - points[last - 1];
    return points[i];
  };
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(points.size()); ++i) {
    const V a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    for (int k = 0; k < segments; ++k) {
      const double t = static_cast<double>(k) / segments;
      curve.push_back(0.5 * ((2.0 * b) + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                             (3.0 * b - a - 3.0 * c + d) * (t * t * t)));
    }
  }
  curve.push_back(points.back());
  return curve;
}
}  // namespace

std::vector<Vec2> smooth(const std::vector<Vec2>& points, int segments) {
  return catmull_rom(points, segments);
}
std::vector<Vec3> smooth(const std::vector<Vec3>& points, int segments) {
  return catmull_rom(points, segments);
}

double Dice::between(double low, double high, std::uint64_t i, std::uint64_t k) const {
  constexpr std::uint64_t kSeed = 20;
  return low + (high - low) * uniform64(kSeed, stream_, i * 64 + k);
}

}  // namespace capcon::scenes
