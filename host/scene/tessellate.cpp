#include "scene/tessellate.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A grid of columns x rows cells over [0,1]^2 as triangles, counter-clockwise in (u, v); cells that a pole
/// makes degenerate are left out.
TriangleMesh grid(int columns, int rows, const std::function<glm::dvec3(double, double)>& point) {
  TriangleMesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      mesh.positions.emplace_back(
          point(static_cast<double>(column) / columns, static_cast<double>(row) / rows));
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) mesh.triangles.emplace_back(a, b, c);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t corner = static_cast<std::uint32_t>(row * (columns + 1) + column);
      const std::uint32_t above = corner + static_cast<std::uint32_t>(columns) + 1;
      add(corner, corner + 1, above + 1);
      add(corner, above + 1, above);
    }
  }
  return mesh;
}

int steps(double part, int full) {
  return std::max(1, static_cast<int>(std::ceil(part * full)));
}

}  // namespace

TriangleMesh tessellate_sphere(double radius, double z_min, double z_max, double phi_max_degrees) {
  const double from = std::acos(std::clamp(z_min / radius, -1.0, 1.0));
  const double to = std::acos(std::clamp(z_max / radius, -1.0, 1.0));
  const double phi_max = phi_max_degrees * kPi / 180;
  return grid(steps(phi_max_degrees / 360, kTurnSteps), steps((from - to) / kPi, kPoleSteps),
              [&](double u, double v) {
                const double theta = from + v * (to - from);
                // Exactly 0 at the poles, so that their points coincide.
                const double ring = (theta == 0 || theta == std::acos(-1.0)) ? 0 : radius * std::sin(theta);
                return glm::dvec3(ring * std::cos(u * phi_max), ring * std::sin(u * phi_max),
                                  radius * std::cos(theta));
              });
}

TriangleMesh tessellate_disk(double radius, double inner_radius, double height, double phi_max_degrees) {
  const double phi_max = phi_max_degrees * kPi / 180;
  return grid(steps(phi_max_degrees / 360, kTurnSteps), 1, [&](double u, double v) {
    const double ring = radius + v * (inner_radius - radius);
    return glm::dvec3(ring * std::cos(u * phi_max), ring * std::sin(u * phi_max), height);
  });
}

}  // namespace capcon
