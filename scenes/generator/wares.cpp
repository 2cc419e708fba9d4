#include "generator/wares.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/surfaces.h"

namespace capcon::scenes {

Mesh gadrooned_bowl(double radius, double height, int lobes, int segments) {
  const double r = radius, h = height;
  std::vector<Vec2> outer =
      smooth(std::vector<Vec2>{{0.36 * r, 0}, {0.42 * r, 0.04 * h}, {0.8 * r, 0.4 * h}, {r, h}}, 10);
  outer.insert(outer.begin(), Vec2(0, 0));
  Profile lip(outer.back().x, outer.back().y);
  lip.curve(-0.05 * r, 0, 1, 6);
  outer.insert(outer.end(), lip.points().begin() + 1, lip.points().end());
  const std::vector<Vec2> inner =
      smooth(std::vector<Vec2>{{0.95 * r, h}, {0.74 * r, 0.42 * h}, {0.34 * r, 0.12 * h}, {0, 0.09 * h}}, 10);
  outer.insert(outer.end(), inner.begin() + 1, inner.end());
  outer.back().x = 0;
  return lathe(outer, segments, [=](double angle, double z) {
    const double depth = 0.045 * std::min(1.0, std::max(0.0, z / h - 0.05) * 3);
    return 1 + depth * std::cos(lobes * angle);
  });
}

Mesh drum(double radius, double height, int segments) {
  Profile profile(radius, -0.01);
  profile.to(radius, height - 0.02).curve(-0.02, 0.02, 0.41421356, 6).to(0, height);
  return lathe(profile.points(), segments);
}

Mesh swirled_vase(double height, int lobes, int segments, int rows) {
  const double h = height;
  const std::vector<Vec2> side = smooth(std::vector<Vec2>{{0.17 * h, 0},
                                                          {0.19 * h, 0.03 * h},
                                                          {0.15 * h, 0.09 * h},
                                                          {0.27 * h, 0.33 * h},
                                                          {0.33 * h, 0.56 * h},
                                                          {0.24 * h, 0.77 * h},
                                                          {0.11 * h, 0.87 * h},
                                                          {0.1 * h, 0.92 * h},
                                                          {0.165 * h, h}},
                                        rows / 8);
  std::vector<Vec2> profile = {{0, 0}};
  profile.insert(profile.end(), side.begin(), side.end());
  Profile lip(profile.back().x, profile.back().y);
  lip.curve(-0.02 * h, 0, 1, 6).to(0.082 * h, 0.92 * h).to(0.09 * h, 0.86 * h).to(0.14 * h, 0.8 * h);
  profile.insert(profile.end(), lip.points().begin() + 1, lip.points().end());
  return lathe(profile, segments, [=](double angle, double z) {
    const double t = z / h,
                 depth = 0.055 * std::clamp((t - 0.08) * 6, 0.0, 1.0) * std::clamp((0.86 - t) * 5, 0.0, 1.0);
    return 1 + depth * std::cos(lobes * angle + 5.5 * t);
  });
}

Mesh lobed_ring(double ring, double bar, int steps, int sides) {
  Mesh mesh;
  mesh.append(
      closed_tube(
          [=](double t) { return Vec3(ring * std::cos(2 * kPi * t), ring * std::sin(2 * kPi * t), 0); },
          [=](double a, double t) { return bar * (1 + 0.26 * std::cos(3 * a + 4 * kPi * t)); }, steps, sides),
      translate(0, 0, ring + 1.2 * bar) * rotate_x(90));
  return mesh;
}

Mesh spiral_ball(double radius, int turns, int rows) {
  return ball(
      [=](const Vec3& d) {
        const double ring = std::hypot(d.x, d.y), angle = std::atan2(d.y, d.x);
        return radius * (1 + 0.1 * ring * ring * std::cos(9 * angle + 6 * d.z)) * (1 - 0.06 * d.z * d.z);
      },
      turns, rows);
}

Mesh nautilus(double size, int steps, int sides) {
  constexpr double kTurns = 2.6, kGrowth = 0.175;  // a turn widens it threefold
  // The section's middle lies at `out` from the pole, its half axes are `flat` and `wide` (along y).
  Mesh mesh = surface(
      [=](double u, double v) {
        const double angle = 2 * kPi * kTurns * (v - 1), grown = std::exp(kGrowth * angle), a = 2 * kPi * u;
        const double ribs = 1 + 0.02 * std::cos(2 * kPi * kTurns * 17 * v);
        const double flat = 0.52 * ribs, wide = 0.46 * ribs, out = 0.5;
        const double r = grown * (out + flat * std::cos(a)), y = grown * wide * std::sin(a);
        return Vec3(r * std::cos(angle), -y, r * std::sin(angle));
      },
      sides, steps, true, false);
  double low = 0, left = 0, right = 0;
  for (const Vec3& p : mesh.positions) {
    low = std::min(low, p.z);
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  const double scaled = size / (right - left);
  for (Vec3& p : mesh.positions) p = scaled * (p - Vec3(0.5 * (left + right), 0, low));
  return mesh;
}

Mesh lemon(double length, int turns, int rows) {
  Mesh mesh = ball(
      [](const Vec3& d) {
        const double along = std::abs(d.z), tip = std::exp(-(1 - along) * 28);
        return 1 + 0.16 * along * along + 0.14 * tip;
      },
      turns, rows);
  Mesh turned;
  const double s = 0.5 * length / 1.3;
  turned.append(mesh, rotate_y(90) * scale(0.92 * s, 0.92 * s, s));
  return turned;
}

}  // namespace capcon::scenes
