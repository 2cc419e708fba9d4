#include <array>
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

glm::dvec2 direction(Dice& dice) {
  const double angle = dice.next(0, 2 * pi);
  return {std::cos(angle), std::sin(angle)};
}

glm::dvec2 in_disk(Dice& dice, double radius) {
  const double r = radius * std::sqrt(dice.next());
  return r * direction(dice);
}

/// Moments of the part x < o of the unit disk, divided by the disk's area.
struct Segment {
  double area, x, xx, yy;
};

Segment segment(double o) {
  const double root = std::sqrt(1 - o * o), arc = std::asin(o) + pi / 2;
  return {(arc + o * root) / pi, -2.0 / 3 * root * root * root / pi,
          (arc - o * root * (1 - 2 * o * o)) / (4 * pi), (o * root * (5 - 2 * o * o) + 3 * arc) / (12 * pi)};
}

/// Area that a circle of radius r about a point at distance c from the unit circle's centre shares with it,
/// over pi.
double shared_area(double c, double r) {
  if (c + r <= 1) return r * r;
  const double a = (c * c + 1 - r * r) / (2 * c),
               b = (c * c + r * r - 1) / (2 * c);  // the chord, seen from both centres
  const double lens =
      std::acos(a) - a * std::sqrt(1 - a * a) + r * r * std::acos(b / r) - b * std::sqrt(r * r - b * b);
  return lens / pi;
}

Draw edge(Dice& dice) {
  const glm::dvec2 d = direction(dice);
  const double o = dice.next(-1, 1);
  const double area = segment(o).area;
  return {average_of([=](glm::dvec2 p) { return glm::dot(d, p) < o ? 1.0 : 0.0; }),
          area,
          indicator_sigma(area),
          {},
          {}};
}

Draw blocker(Dice& dice) {
  const glm::dvec2 c = in_disk(dice, 1);
  const double r = dice.next(0.2, 0.6);
  const double area = 1 - shared_area(glm::length(c), r);
  return {average_of([=](glm::dvec2 p) { return glm::dot(p - c, p - c) < r * r ? 0.0 : 1.0; }),
          area,
          indicator_sigma(area),
          {},
          {}};
}

Draw leaves(Dice& dice) {
  constexpr double kRadius = 0.18;
  std::array<glm::dvec2, 6> c;
  for (std::size_t i = 0;
       i < c.size();) {  // by rejection: inside the disk and apart, so that the areas add up
    c[i] = in_disk(dice, 1 - kRadius);
    bool apart = true;
    for (std::size_t j = 0; j < i; ++j) apart &= glm::distance(c[i], c[j]) >= 2 * kRadius;
    i += apart ? 1 : 0;
  }
  const double area = 1 - static_cast<double>(c.size()) * kRadius * kRadius;
  return {average_of([c](glm::dvec2 p) {
            bool blocked = false;
            for (const glm::dvec2& centre : c)
              blocked |= glm::dot(p - centre, p - centre) < kRadius * kRadius;
            return blocked ? 0.0 : 1.0;
          }),
          area,
          indicator_sigma(area),
          {},
          {}};
}

Draw smooth_disk(Dice& dice) {
  constexpr double kWave = 2;
  const glm::dvec2 d = kWave * direction(dice);
  const double phase = dice.next(0, 2 * pi);
  const auto mean_wave = [](double k) {
    return 2 * std::cyl_bessel_j(1.0, k) / k;
  };  // of cos(k x) over the disk
  const double wave = std::cos(phase) * mean_wave(kWave);
  const double square = (1 + std::cos(2 * phase) * mean_wave(2 * kWave)) / 2;  // of the cosine
  return {average_of([=](glm::dvec2 p) { return 1 + std::cos(glm::dot(d, p) + phase); }),
          1 + wave,
          std::sqrt(square - wave * wave),
          {},
          {}};
}

Draw shaded_edge(Dice& dice) {
  const glm::dvec2 d = direction(dice), g = direction(dice);
  const double o = dice.next(-1, 1);
  const Segment s = segment(o);
  const double along = glm::dot(g, d), across2 = 1 - along * along;
  const double mean = s.area + along * s.x;
  const double square = s.area + 2 * along * s.x + along * along * s.xx + across2 * s.yy;
  return {average_of([=](glm::dvec2 p) { return glm::dot(d, p) < o ? 1 + glm::dot(g, p) : 0.0; }),
          mean,
          std::sqrt(std::max(0.0, square - mean * mean)),
          {},
          {}};
}

Integrand on_disk(const std::string& name, std::string title, std::string formula, bool edges,
                  Draw (*draw)(Dice&)) {
  Integrand result{name, std::move(title), std::move(formula), Domain::disk, edges, true, {}, {}, {}, {}};
  result.variation_note =
      edges ? "infinite: f jumps along a curve" : "not known in closed form, for the map's sake";
  result.draw = [name, draw](std::uint64_t seed, std::uint64_t trial) {
    Dice dice(seed, name, trial);
    return draw(dice);
  };
  result.no_importance = "each trial has its own f";
  return result;
}

}  // namespace

std::vector<Integrand> disk_integrands() {
  return {on_disk("edge-on-disk", "Half-plane on the disk",
                  "f = 1 on one side of a line at a distance from −1 to 1 of the centre; the integral is "
                  "that of a circular segment.",
                  true, edge),
          on_disk("blocker", "One round blocker",
                  "f = 0 behind a round blocker of radius 0.2 to 0.6 centred anywhere in the disk, 1 "
                  "elsewhere; the integral is that of a "
                  "lens.",
                  true, blocker),
          on_disk("leaves", "Six small blockers",
                  "f = 0 behind six round blockers of radius 0.18 that lie in the disk without touching; the "
                  "integral is 1 − 6 · 0.18².",
                  true, leaves),
          on_disk("smooth-disk", "Smooth on the disk",
                  "f = 1 + cos(2 d·p + φ), direction d and phase φ random; the mean over the disk is 1 + cos "
                  "φ · J₁(2), J₁ the Bessel function.",
                  false, smooth_disk),
          on_disk("shaded-edge", "Smooth times an edge",
                  "f = 1 + g·p on one side of a line as above, 0 on the other, g a random direction; the "
                  "integral is a segment's first "
                  "moments.",
                  true, shaded_edge)};
}

}  // namespace capcon::integrate
