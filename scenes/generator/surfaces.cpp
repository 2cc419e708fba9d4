#include "generator/surfaces.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace capcon::scenes {

Mesh surface(const Surface& shape, int nu, int nv, bool wrap_u, bool wrap_v) {
  Mesh mesh;
  const int columns = wrap_u ? nu : nu + 1, rows = wrap_v ? nv : nv + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      mesh.vertex(shape(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((wrap_v ? j % nv : j) * columns + (wrap_u ? i % nu : i));
  };
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) mesh.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return mesh;
}

Mesh closed_tube(const std::function<Vec3(double)>& curve,
                 const std::function<double(double, double)>& section, int steps, int sides) {
  // A frame carried along the curve with least turning comes back turned; that turn is undone evenly.
  std::vector<Vec3> points, aheads, rights;
  for (int i = 0; i < steps; ++i) points.push_back(curve(static_cast<double>(i) / steps));
  for (int i = 0; i < steps; ++i)
    aheads.push_back(glm::normalize(points[(i + 1) % steps] - points[(i + steps - 1) % steps]));
  const auto carried = [&](const Vec3& right, const Vec3& ahead) {
    return glm::normalize(right - ahead * glm::dot(right, ahead));
  };
  rights.push_back(carried(std::abs(aheads[0].z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), aheads[0]));
  for (int i = 1; i < steps; ++i) rights.push_back(carried(rights.back(), aheads[i]));
  const Vec3 last = carried(rights.back(), aheads[0]), up = glm::cross(aheads[0], rights[0]);
  const double twist = std::atan2(glm::dot(last, up), glm::dot(last, rights[0]));
  return surface(
      [&](double u, double v) {
        const int i = static_cast<int>(std::lround(v * steps)) % steps;
        const double a = 2 * kPi * u, turned = a - twist * v;
        const Vec3 top = glm::cross(aheads[i], rights[i]);
        return points[i] + section(a, v) * (std::cos(turned) * rights[i] + std::sin(turned) * top);
      },
      sides, steps, true, true);
}

Vec3 torus_knot(double t, int p, int q, double ring, double tube) {
  const double a = 2 * kPi * p * t, b = 2 * kPi * q * t, r = ring + tube * std::cos(b);
  return {r * std::cos(a), r * std::sin(a), tube * std::sin(b)};
}

Mesh ball(const std::function<double(const Vec3&)>& shape, int turns, int rows) {
  Mesh mesh = surface(
      [&](double u, double v) {
        const double a = 2 * kPi * u, theta = kPi * (1 - v);
        const bool pole = v == 0 || v == 1;
        const double ring = pole ? 0.0 : std::sin(theta);
        const Vec3 d(ring * std::cos(a), ring * std::sin(a), std::cos(theta));
        return shape(d) * d;
      },
      turns, rows, true, false);
  return mesh;
}

std::vector<Vec2> rounded_rectangle(double width, double depth, double round, int segments) {
  std::vector<Vec2> section;
  const double x = 0.5 * width - round, y = 0.5 * depth - round;
  const Vec2 middles[4] = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  for (int c = 0; c < 4; ++c) {
    for (int i = 0; i <= segments; ++i) {
      const double a = kPi / 2 * (c - 1 + static_cast<double>(i) / segments);
      section.push_back(middles[c] + round * Vec2(std::cos(a), std::sin(a)));
    }
  }
  return section;
}

}  // namespace capcon::scenes
