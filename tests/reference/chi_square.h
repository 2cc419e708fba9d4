#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "reference/hemisphere.h"

namespace capcon::test {

/// Directions that a sampler gives against the density that it claims.
struct ChiSquare {
  double integral = 0;  ///< of the density over all directions
  double nothing = 0;   ///< part of the samples that have no direction
  double sigmas = 0;  ///< of chi^2 above what agreement gives, by Wilson and Hilferty's normal approximation
};

/// Bins are rings about `axis` out to the angle `reach`, denser near it, in sectors; the density beyond must
/// be 0. A sample that is none counts as a bin of its own, whose probability is what the density lacks.
inline ChiSquare chi_square(const glm::dvec3& axis,
                            const std::function<std::optional<glm::dvec3>(const glm::dvec2&, double)>& sample,
                            const std::function<double(const glm::dvec3&)>& pdf,
                            double reach = std::numbers::pi, std::uint32_t count = 40000) {
  constexpr int kRings = 30, kTurns = 12, kSteps = 40, kSideSteps = 12;  // steps: of the quadrature, in a bin
  const reference::Frame frame(axis);
  const auto bin_of = [&](const glm::dvec3& direction) {
    const glm::dvec3 d = frame.to_local(direction);
    const double theta = std::atan2(std::hypot(d.x, d.y), d.z),
                 turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi);
    const int ring = std::min(int(std::sqrt(theta / reach) * kRings), kRings - 1);
    return ring * kTurns + std::min(int((turn - std::floor(turn)) * kTurns), kTurns - 1);
  };
  std::vector<double> expected(kRings * kTurns + 1), seen(expected.size());
  for (int i = 0; i < kRings * kSteps; ++i) {
    const auto theta_of = [&](double ring) { return ring * ring * reach / (kRings * kRings); };
    const double from = double(i) / kSteps, to = double(i + 1) / kSteps, theta = theta_of((from + to) / 2);
    const double patch =
        (std::cos(theta_of(from)) - std::cos(theta_of(to))) * 2 * std::numbers::pi / (kTurns * kSideSteps);
    for (int j = 0; j < kTurns * kSideSteps; ++j) {
      const double phi = (j + 0.5) / (kTurns * kSideSteps) * 2 * std::numbers::pi;
      const glm::dvec3 local(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
      expected[i / kSteps * kTurns + j / kSideSteps] += pdf(frame.to_world(local)) * patch;
    }
  }
  ChiSquare result;
  for (const double e : expected) result.integral += e;
  expected.back() = std::max(0.0, 1 - result.integral);
  std::mt19937 random(1);
  const auto unit = [&] { return double(random() >> 8) / 16777216.0; };  // as sample points are
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec2 u(unit(), unit());
    const auto direction = sample(u, unit());
    ++seen[direction ? bin_of(*direction) : expected.size() - 1];
  }
  result.nothing = seen.back() / count;
  // Bins that few samples are expected in are taken together.
  double chi2 = 0, rest_expected = 0, rest_seen = 0;
  int freedom = -1;
  for (std::size_t b = 0; b < expected.size(); ++b) {
    const double e = expected[b] * count;
    if (e < 10) {
      rest_expected += e, rest_seen += seen[b];
      continue;
    }
    chi2 += (seen[b] - e) * (seen[b] - e) / e;
    ++freedom;
  }
  if (rest_seen > 0 || rest_expected > 1) {
    chi2 += std::pow(rest_seen - rest_expected, 2) / std::max(rest_expected, 1.0);
    ++freedom;
  }
  if (freedom < 1) freedom = 1;
  const double nine = 2.0 / (9 * freedom);
  result.sigmas = (std::cbrt(chi2 / freedom) - (1 - nine)) / std::sqrt(nine);
  return result;
}

}  // namespace capcon::test
