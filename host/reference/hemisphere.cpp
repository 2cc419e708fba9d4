#include "reference/hemisphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace capcon::reference {

glm::dvec2 concentric_disk(double u, double v) {
  constexpr double kQuarterPi = std::numbers::pi / 4;
  const double a = 2 * u - 1;
  const double b = 2 * v - 1;
  if (a == 0 && b == 0) return {0, 0};
  const bool sideways = std::abs(a) > std::abs(b);
  const double r = sideways ? a : b;
  const double phi = sideways ? kQuarterPi * (b / a) : 2 * kQuarterPi - kQuarterPi * (a / b);
  return {r * std::cos(phi), r * std::sin(phi)};
}

glm::dvec3 cosine_hemisphere(double u, double v) {
  const glm::dvec2 d = concentric_disk(u, v);
  return {d.x, d.y, std::sqrt(std::max(0.0, 1 - d.x * d.x - d.y * d.y))};
}

Frame::Frame(const glm::dvec3& n) : normal(n) {
  const double s = n.z >= 0 ? 1 : -1;
  const double a = -1 / (s + n.z);
  const double b = n.x * n.y * a;
  tangent = {1 + s * n.x * n.x * a, s * b, -s * n.x};
  bitangent = {b, s + n.y * n.y * a, -n.y};
}

glm::dvec3 around_normal(const glm::dvec3& n, const glm::dvec3& local) {
  return Frame(n).to_world(local);
}

}  // namespace capcon::reference
