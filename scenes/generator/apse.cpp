#include <cmath>
#include <glm/geometric.hpp>

#include "generator/nave.h"
#include "generator/nave_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/tracery.h"
#include "generator/vault.h"
#include "generator/wall.h"

namespace capcon::scenes::church {

namespace {
constexpr int kSides = 5;  // of a decagon

Vec2 corner(int i) {
  const double a = kPi * (static_cast<double>(i) / kSides - 0.5);
  return {kApse + kFace * std::cos(a), kFace * std::sin(a)};
}

/// One side: a tall lancet over a blind arcade, the wall's face at y = 0, round its middle.
Model side(double half) {
  Model model;
  const Opening window{
      .half_width = 0.62, .sill = 4.4, .springing = 11.3, .arch = Arch::pointed, .segments = 18};
  WallPlan dado{
      .from = -half, .to = half, .foot = -0.05, .head = 3.6, .thickness = 0.22, .back = false, .top = false};
  for (const double x : {-0.52, 0.52}) {
    dado.openings.push_back({.centre = x,
                             .half_width = 0.4,
                             .sill = kPlatform + 0.35,
                             .springing = 2.3,
                             .arch = Arch::pointed,
                             .segments = 14});
    model.add("stone", archivolt(dado.openings.back(),
                                 {{0.09, -0.01}, {0.09, 0.03}, {0.02, 0.04}, {-0.02, 0.0}}, false));
  }
  model.add("wall", wall(dado));
  model.add("wall", box(Vec3(-half, 0.21, 0.5), Vec3(half, 0.22, 3.2), kSouth));
  model.add("wall", wall({.from = -half,
                          .to = half,
                          .foot = 3.6,
                          .head = kHead,
                          .thickness = 0.5,
                          .back = false,
                          .top = false,
                          .openings = {window}}));
  model.add("stone", hood(window));
  model.add(lancet(window, 0.3));
  Profile course(-0.01, 3.46);
  course.by(0.03, 0).curve(0.06, 0.06, -0.4, 3).by(0.02, 0).by(0, 0.05).to(-0.01, 3.62);
  model.add("stone", moulding(course.points(), {Vec3(half, 0, 0), Vec3(-half, 0, 0)}, false));
  return model;
}

/// The slim shaft in each corner, carrying a rib.
Mesh corner_shaft() {
  const double h = kTriforiumHead;
  Profile p(0.2, kPlatform - 0.02);
  p.by(0, 0.12)
      .curve(-0.03, 0.06, 0.7, 3)
      .curve(-0.06, 0.06, -0.4, 3)
      .to(0.11, h - 0.4)
      .by(0.03, 0)
      .curve(0, 0.04, 1, 3)
      .by(-0.03, 0.01);
  p.curve(0.08, 0.22, -0.3, 4).by(0.03, 0).by(0, 0.1).to(0.02, h);
  return lathe(p.points(), 10);
}

/// The raised floor: three steps, each the apse's outline moved west.
Mesh platform() {
  Mesh mesh;
  const double rise = kPlatform / 3;
  for (int i = 0; i < 3; ++i) {
    const double x = kApse - 1.05 + 0.35 * i, z = (i + 1) * rise;
    mesh.append(bevelled_box(Vec3(x, -kFace - 0.02, z - rise - 0.02), Vec3(x + 0.5, kFace + 0.02, z), 0.012));
  }
  const double z = kPlatform - 0.004;
  const std::uint32_t centre = mesh.vertex(Vec3(kApse - 0.2, 0, z));
  std::vector<std::uint32_t> rim = {mesh.vertex(Vec3(kApse - 0.2, -kFace, z))};
  for (int i = 0; i <= kSides; ++i) rim.push_back(mesh.vertex(Vec3(corner(i), z)));
  rim.push_back(mesh.vertex(Vec3(kApse - 0.2, kFace, z)));
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) mesh.triangle(centre, rim[i], rim[i + 1]);
  return mesh;
}
}  // namespace

void add_apse(Assembly& scene) {
  const Vec2 centre(kApse, 0);
  const double half = 0.5 * glm::length(corner(1) - corner(0));
  scene.define("apse-side", side(half));
  Model shell, ribs;
  for (int i = 0; i < kSides; ++i) {
    const Vec2 a = corner(i), b = corner(i + 1), middle = 0.5 * (a + b);
    const double turn =
        std::atan2(middle.y, middle.x - kApse) * 180 / kPi - 90;  // the wall's +y points away from the centre
    scene.place("apse-side", translate(middle.x, middle.y, 0) * rotate_z(turn));
    shell.add("web", apse_gore(a, b, centre, kFace, 8), translate(0, 0, kTriforiumHead));
    const auto wall_height = [](double t) { return pointed_height(1 - std::abs(2 * t - 1), kFace); };
    ribs.add("stone", rib(a, b, wall_height, 0.28, 0.13, 14), translate(0, 0, kTriforiumHead));
  }
  for (int i = 0; i <= kSides; ++i) {
    const auto height = [](double t) { return pointed_height(t, kFace); };
    ribs.add("stone", rib(corner(i), centre, height, 0.24, 0.24, 14), translate(0, 0, kTriforiumHead));
    const Vec2 inward = corner(i) + 0.06 * (centre - corner(i)) / kFace;
    ribs.add("stone", corner_shaft(), translate(inward.x, inward.y, 0));
  }
  ribs.add("stone", vault_boss(0.42), translate(kApse, 0, kTriforiumHead + pointed_height(1, kFace) - 0.16));
  // Between the nave and the apse: a strip of barrel and of wall.
  Mesh strip;
  constexpr int kSegments = 20;
  for (int i = 0; i < kSegments; ++i) {
    const auto point = [&](double x, int k) {
      const double t = 2.0 * k / kSegments - 1,
                   y = kFace * std::copysign(std::cos(0.5 * kPi * (1 - std::abs(t))), t);
      return Vec3(x, y, kTriforiumHead + pointed_height(1 - std::abs(y) / kFace, kFace));
    };
    strip.quad(point(kLength, i), point(kLength, i + 1), point(kApse, i + 1), point(kApse, i));
  }
  shell.add("web", strip);
  for (const double y : {1.0, -1.0}) {
    Mesh cheek;
    cheek.quad(Vec3(kLength, kFace, kCapital - 5), Vec3(kApse, kFace, kCapital - 5),
               Vec3(kApse, kFace, kTriforiumHead), Vec3(kLength, kFace, kTriforiumHead));
    shell.add("wall", cheek, scale(1, y, 1));
  }
  scene.add("apse-vault", std::move(shell));
  scene.add("apse-ribs", std::move(ribs));
  Model steps;
  steps.add("stone", platform());
  scene.add("platform", std::move(steps));
}

}  // namespace capcon::scenes::church
