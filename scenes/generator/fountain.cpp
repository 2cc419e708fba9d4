#include <cmath>

#include "generator/courtyard.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::court {

namespace {
/// Two octagonal steps of bevelled edge, and the round basin with its moulded wall.
Mesh basin() {
  Mesh mesh;
  const auto step = [&](double radius, double foot, double head) {
    Profile p(radius, foot);
    p.to(radius, head - 0.06).by(0.03, 0.005).by(0, 0.03).by(-0.02, 0.025).to(0.3, head);
    mesh.append(lathe(p.points(), 8), rotate_z(22.5));
  };
  step(2.2, -0.04, 0.16);
  step(1.82, 0.1, 0.31);
  Profile p(1.42, 0.3);
  p.by(0.05, 0)
      .by(0, 0.06)
      .curve(0, 0.07, 1, 6)
      .by(-0.06, 0.015)
      .curve(-0.02, 0.28, 0.12, 6)
      .curve(0.05, 0.06, -0.4, 4);
  p.by(0.025, 0)
      .curve(0, 0.1, 0.8, 6)
      .by(-0.02, 0.02)
      .by(-0.2, 0)
      .by(-0.02, -0.02)
      .to(1.2, 0.75)
      .to(1.17, 0.42)
      .to(0.2, 0.4);
  mesh.append(lathe(p.points(), 64));
  return mesh;
}

/// A shallow bowl on a turned stem: the bowl's rim is at `rim`, the stem starts at `foot`.
Mesh bowl(double foot, double rim, double radius) {
  const double h = rim - foot, s = radius;
  std::vector<Vec2> stem = smooth({{0.3 * s, foot},
                                   {0.3 * s, foot + 0.07 * h},
                                   {0.17 * s, foot + 0.16 * h},
                                   {0.27 * s, foot + 0.34 * h},
                                   {0.24 * s, foot + 0.46 * h},
                                   {0.13 * s, foot + 0.6 * h},
                                   {0.15 * s, foot + 0.68 * h},
                                   {0.25 * s, foot + 0.72 * h}},
                                  3);
  Mesh mesh = lathe(stem, 32);
  Profile p(0.2 * s, foot + 0.715 * h);
  p.curve(0.68 * s, 0.2 * h, 0.35, 8).by(0.02 * s, 0).by(0, 0.02 * h);
  const auto gadroons = [&](double angle, double z) {
    const double t = (z - foot - 0.715 * h) / (0.2 * h);
    return 1 + 0.035 * std::abs(std::sin(10 * angle)) * (t > 0.98 ? 0.0 : std::sin(kPi * std::max(0.0, t)));
  };
  mesh.append(lathe(p.points(), 80, gadroons));
  Profile rim_profile(0.88 * s, foot + 0.932 * h);
  rim_profile.by(0.05 * s, 0.02 * h)
      .curve(0.02 * s, 0.04 * h, 0.7, 5)
      .by(-0.06 * s, 0.008 * h)
      .by(-0.03 * s, -0.01 * h);
  rim_profile.curve(-0.5 * s, -0.14 * h, -0.15, 5).to(0.05 * s, foot + 0.84 * h);
  mesh.append(lathe(rim_profile.points(), 80));
  return mesh;
}

/// A pine cone of overlapping scales.
Mesh finial(double foot) {
  std::vector<Vec2> body = {{0.1, foot}, {0.1, foot + 0.03}, {0.045, foot + 0.05}, {0.045, foot + 0.08}};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    body.emplace_back(std::max(0.0, 0.095 * std::sqrt(std::sin(kPi * std::min(1.0, 0.1 + 0.9 * t)))),
                      foot + 0.08 + 0.27 * t);
  }
  body.back().x = 0;
  return lathe(body, 48, [&](double angle, double z) {
    const double row = (z - foot) / 0.03;
    return z < foot + 0.1 || z > foot + 0.34
               ? 1.0
               : 1 + 0.09 * std::sin(8 * angle + kPi * std::floor(row)) * (1.3 - (row - std::floor(row)));
  });
}

/// Water with rings running out from where the jets fall.
Mesh water(double radius, double z, double ripple) {
  constexpr int kRings = 22, kSegments = 48;
  std::vector<Vec2> profile;
  for (int i = kRings; i >= 0; --i) {
    const double r = radius * i / kRings;
    profile.emplace_back(r, z + ripple * std::sin(36 * r) * std::exp(-1.5 * r));
  }
  return lathe(profile, kSegments);
}

/// Thin jets from a bowl's rim down to the water.
Mesh jets(double radius, double top, double reach, double bottom, int count) {
  std::vector<Vec3> points;
  std::vector<double> radii;
  for (int i = 0; i <= 12; ++i) {
    const double t = i / 12.0;
    points.emplace_back(radius + reach * t, 0, top - (top - bottom) * t * t);
    radii.push_back(0.008 - 0.003 * t);
  }
  const Mesh jet = tube(points, radii, 6);
  Mesh mesh;
  for (int i = 0; i < count; ++i) mesh.append(jet, rotate_z(360.0 * i / count));
  return mesh;
}
}  // namespace

void add_fountain(Assembly& scene) {
  Model model;
  model.add("stone", basin());
  model.add("stone", bowl(0.38, 1.72, 0.72));
  model.add("stone", bowl(1.6, 2.4, 0.36));
  model.add("stone", finial(2.27));
  model.add("water", water(1.19, 0.8, 0.006));
  model.add("water", jets(0.69, 1.725, 0.14, 0.79, 8));
  model.add("water", jets(0.345, 2.405, 0.1, 1.66, 6));
  scene.add("fountain", std::move(model));
}

}  // namespace capcon::scenes::court
