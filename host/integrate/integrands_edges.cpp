#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "integrate/integrand.h"

namespace capcon::integrate {
namespace {

using std::numbers::pi;

double indicator_sigma(double area) {
  return std::sqrt(area * (1 - area));
}

/// The line d.(p - q) = 0 through a random point q of the square, in a random direction d.
struct RandomLine {
  glm::dvec2 d, q;
};

RandomLine random_line(Dice& dice) {
  const double angle = dice.next(0, 2 * pi);
  glm::dvec2 d(std::cos(angle), std::sin(angle));
  // Not closer to the axes than this: the closed forms divide by both components.
  constexpr double kLeast = 1e-6;
  for (int axis = 0; axis < 2; ++axis) d[axis] = std::copysign(std::max(std::abs(d[axis]), kLeast), d[axis]);
  return {glm::normalize(d), {dice.next(), dice.next()}};
}

/// The square seen along a line's normal, its lowest corner at 0: repeated integrals of the chord's length.
class Shadow {
 public:
  explicit Shadow(glm::dvec2 d)
      : a_(std::abs(d.x)), b_(std::abs(d.y)), origin_(std::min(d.x, 0.0) + std::min(d.y, 0.0)) {}

  /// Of a value of d.p.
  double height(double along) const { return along - origin_; }
  double chord(double c) const { return corners(c, 1); }     ///< length of the line at height c in the square
  double area(double c) const { return corners(c, 2) / 2; }  ///< of the square below height c
  double area_integral(double c) const { return corners(c, 3) / 6; }    ///< of area from 0 to c
  double area_integral2(double c) const { return corners(c, 4) / 24; }  ///< and once more

 private:
  double corners(double c, int power) const {
    const auto ramp = [&](double v) { return v > 0 ? std::pow(v, power) : 0; };
    return (ramp(c) - ramp(c - a_) - ramp(c - b_) + ramp(c - a_ - b_)) / (a_ * b_);
  }
  double a_, b_, origin_;
};

Integrand disk() {
  Integrand result{
      "disk",
      "Disk",
      "f = 1 inside a disk that lies anywhere in the square, radius r from 0.1 to 0.4; the integral is πr².",
      Domain::square,
      true,
      true,
      "infinite: f jumps along a curve",
      {},
      {},
      {}};
  result.draw = [](std::uint64_t seed, std::uint64_t trial) {
    Dice dice(seed, "disk", trial);
    const double r = dice.next(0.1, 0.4);
    const glm::dvec2 c(dice.next(r, 1 - r), dice.next(r, 1 - r));
    const double area = pi * r * r;
    return Draw{average_of([=](glm::dvec2 p) { return glm::dot(p - c, p - c) < r * r ? 1.0 : 0.0; }),
                area,
                indicator_sigma(area),
                {},
                {}};
  };
  return result;
}

Integrand half_plane() {
  Integrand result{"half-plane",
                   "Half-plane",
                   "f = 1 on one side of a line through a random point in a random direction; the integral "
                   "is the area it cuts "
                   "off, quadratic by pieces.",
                   Domain::square,
                   true,
                   true,
                   "infinite: f jumps along an oblique line",
                   {},
                   {},
                   {}};
  result.draw = [](std::uint64_t seed, std::uint64_t trial) {
    Dice dice(seed, "half-plane", trial);
    const RandomLine line = random_line(dice);
    const Shadow shadow(line.d);
    const double area = std::clamp(shadow.area(shadow.height(glm::dot(line.d, line.q))), 0.0, 1.0);
    return Draw{average_of([d = line.d, o = glm::dot(line.d, line.q)](glm::dvec2 p) {
                  return glm::dot(d, p) < o ? 1.0 : 0.0;
                }),
                area,
                indicator_sigma(area),
                {},
                {}};
  };
  return result;
}

Integrand soft_shadow() {
  Integrand result{"soft-shadow",
                   "Soft shadow",
                   "f rises linearly from 0 to 1 over a band of width 0.25 through a random point in a "
                   "random direction; the "
                   "integral is cubic by pieces.",
                   Domain::square,
                   false,
                   true,
                   {},
                   {},
                   {},
                   {}};
  result.draw = [](std::uint64_t seed, std::uint64_t trial) {
    constexpr double kWidth = 0.25;
    Dice dice(seed, "soft-shadow", trial);
    const glm::dvec2 d = random_line(dice).d;
    const double start = glm::dot(d, glm::dvec2(dice.next(), dice.next())) - kWidth / 2;
    const auto f = [d, start](glm::dvec2 p) {
      return std::clamp((glm::dot(d, p) - start) / kWidth, 0.0, 1.0);
    };
    // The mean of f is the integral over s of P(f > s), the mean of its square that of 2 s P(f > s).
    const Shadow shadow(d);
    const double low = shadow.height(start), high = low + kWidth;
    const double mean = 1 - (shadow.area_integral(high) - shadow.area_integral(low)) / kWidth;
    const double square = 1 - 2 / (kWidth * kWidth) *
                                  (kWidth * shadow.area_integral(high) - shadow.area_integral2(high) +
                                   shadow.area_integral2(low));
    // The mixed derivative lives on the two lines where the slope changes, with weight |dx dy| / width there.
    const double vitali = std::abs(d.x * d.y) / kWidth * (shadow.chord(low) + shadow.chord(high));
    const double sides = std::abs(f({1, 1}) - f({0, 1})) + std::abs(f({1, 1}) - f({1, 0}));
    return Draw{average_of(f), mean, std::sqrt(std::max(0.0, square - mean * mean)), vitali + sides, {}};
  };
  return result;
}

}  // namespace

std::vector<Integrand> edge_integrands() {
  std::vector<Integrand> all{soft_shadow(), disk(), half_plane()};
  for (Integrand& integrand : all) {
    integrand.no_importance = integrand.edges ? "to know where f is 1 is to know the integral"
                                              : "the band lies elsewhere in each trial";
  }
  return all;
}

}  // namespace capcon::integrate
