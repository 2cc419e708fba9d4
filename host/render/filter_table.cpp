#include "render/filter_table.h"

#include <cmath>

#include "layout.h"
#include "render/texels.h"

namespace capcon {
namespace {

constexpr double kRadius = 1.5;

double cumulative(double t) {
  const double edge = std::exp(-2 * kRadius * kRadius);
  const auto integral = [&](double x) {
    return std::sqrt(3.14159265358979323846 / 8) * std::erf(std::sqrt(2.0) * x) - edge * x;
  };
  return (integral(t) + integral(kRadius)) / (2 * integral(kRadius));
}

double quantile(double p) {
  double low = -kRadius, high = kRadius;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (cumulative(middle) < p ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::vector<glm::uvec4> gaussian_filter_table() {
  constexpr std::uint32_t kParts = layout::kFilterIntervals;
  std::vector<glm::uvec4> texels;
  double value = -kRadius;
  for (std::uint32_t i = 0; i < kParts; ++i) {
    const double next = i + 1 == kParts ? kRadius : quantile((i + 1.0) / kParts);
    texels.emplace_back(float_bits(value), float_bits(next - value), 0, 0);
    value = next;
  }
  return texels;
}

}  // namespace capcon
