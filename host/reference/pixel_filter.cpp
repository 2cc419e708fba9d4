#include "reference/pixel_filter.h"

#include <cmath>
#include <numbers>

namespace capcon::reference {
namespace {

constexpr double kRadius = 1.5;

/// Integral of the filter from 0 to t.
double area(double t) {
  const double root = std::numbers::sqrt2;
  return std::sqrt(std::numbers::pi) / (2 * root) * std::erf(root * t) - std::exp(-2 * kRadius * kRadius) * t;
}

}  // namespace

double gaussian_quantile(double u) {
  const double wanted = (2 * u - 1) * area(kRadius);
  double low = -kRadius, high = kRadius;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (area(middle) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace capcon::reference
