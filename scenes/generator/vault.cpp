#include "generator/vault.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

double pointed_height(double s, double half) {
  const double radius = 1.55 * half, u = radius - std::clamp(s, 0.0, 1.0) * half;
  return std::sqrt(radius * radius - u * u);
}

namespace {
/// Samples from 0 to 1 that crowd at the springing, where the curve is steep.
double crowded(int i, int segments) {
  return 1 - std::cos(0.5 * kPi * i / segments);
}
}  // namespace

Mesh groin_vault(double length, double half_width, double half, int segments) {
  // The eighth between the springing at the corner (0, 0), the middle of one edge and the key; all the others
  // are its mirror images. In the cell over an edge the height depends only on the place along that edge.
  Mesh mesh;
  const Vec2 extent(0.5 * length, half_width);
  for (int cell = 0; cell < 2; ++cell) {  // 0: cells on the transverse arches, 1: cells on the walls
    Mesh eighth;
    for (int i = 0; i < segments; ++i) {
      const double s0 = crowded(i, segments), s1 = crowded(i + 1, segments);
      const auto point = [&](double s, double along) {
        const Vec2 p = cell == 0 ? Vec2(along * s, s) : Vec2(s, along * s);
        return Vec3(p.x * extent.x, p.y * extent.y, pointed_height(s, half));
      };
      eighth.quad(point(s0, 0), point(s0, 1), point(s1, 1), point(s1, 0));
    }
    if (cell == 0) eighth.flip();
    for (const double x : {1.0, -1.0}) {
      for (const double y : {1.0, -1.0}) {
        mesh.append(eighth,
                    translate(x > 0 ? 0 : length, y > 0 ? -half_width : half_width, 0) * scale(x, y, 1));
      }
    }
  }
  return mesh;
}

Mesh apse_gore(const Vec2& a, const Vec2& b, const Vec2& centre, double half, int segments) {
  Mesh mesh;
  const int across = 2 * segments;
  const auto along = [&](int j) {
    return j <= segments ? 0.5 * crowded(j, segments) : 1 - 0.5 * crowded(across - j, segments);
  };
  for (int i = 0; i <= segments; ++i) {
    const double q = 1 - crowded(i, segments);
    for (int j = 0; j <= across; ++j) {
      const double t = along(j), m = 1 - std::abs(2 * t - 1);
      const Vec2 p = centre + q * (a + t * (b - a) - centre);
      mesh.vertex(Vec3(p.x, p.y, pointed_height(1 - q * (1 - m), half)));
    }
  }
  const std::uint32_t n = across + 1;
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < across; ++j) {
      const std::uint32_t v = i * n + j;
      mesh.quad(v, v + n, v + n + 1, v + 1);
    }
  }
  const Vec3 probe =
      glm::cross(mesh.positions[n] - mesh.positions[0], mesh.positions[n + 1] - mesh.positions[0]);
  if (probe.z > 0) mesh.flip();
  return mesh;
}

Mesh rib(const Vec2& a, const Vec2& b, const std::function<double(double)>& height, double width,
         double depth, int segments) {
  const Vec2 plan = glm::normalize(b - a);
  const Vec3 right(-plan.y, plan.x, 0);
  std::vector<Vec3> points;
  for (int i = 0; i <= segments; ++i) {
    const double t =
        i * 2 <= segments ? 0.5 * crowded(i, segments / 2) : 1 - 0.5 * crowded(segments - i, segments / 2);
    const Vec2 p = a + t * (b - a);
    points.emplace_back(p.x, p.y, height(t));
  }
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 ahead =
        glm::normalize(points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1]);
    frames.push_back({points[i], right, glm::cross(ahead, right)});
  }
  const double w = 0.5 * width, d = depth;
  const std::vector<Vec2> section = {
      {-w, 0.05}, {-w, -0.45 * d},     {-0.55 * w, -0.52 * d}, {-0.4 * w, -0.9 * d},
      {0, -d},    {0.4 * w, -0.9 * d}, {0.55 * w, -0.52 * d},  {w, -0.45 * d},
      {w, 0.05}};
  return sweep(section, false, frames, Ends::capped);
}

Mesh vault_boss(double radius) {
  Profile p(0.0, -0.16);
  p.to(0.4 * radius, -0.15)
      .curve(0.35 * radius, 0.06, 0.3, 2)
      .by(0.02, 0)
      .curve(0.25 * radius, 0.12, 0.3, 2)
      .by(0, 0.2);
  return lathe(p.points(), 16, [](double angle, double) { return 1 + 0.1 * std::cos(8 * angle); });
}

}  // namespace capcon::scenes
