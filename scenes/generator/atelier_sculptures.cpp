#include <cmath>
#include <glm/geometric.hpp>

#include "generator/atelier.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/surfaces.h"
#include "generator/wares.h"

namespace capcon::scenes::studio {

namespace {
constexpr double kCrease = 40;

/// A ball of hoops: meridians and parallels of thin bars.
Mesh cage(double radius, double bar) {
  constexpr int kMeridians = 9, kParallels = 5, kSteps = 72, kSides = 6;
  Mesh mesh;
  const auto hoop = [&](double ring, double z, const Matrix& turn) {
    mesh.append(
        closed_tube(
            [&](double t) { return Vec3(ring * std::cos(2 * kPi * t), ring * std::sin(2 * kPi * t), z); },
            [&](double, double) { return bar; }, kSteps, kSides),
        turn);
  };
  for (int i = 0; i < kMeridians; ++i)
    hoop(radius * (1 + 0.0004 * i), 0, rotate_z(180.0 * i / kMeridians) * rotate_x(90));
  for (int i = 1; i <= kParallels; ++i) {
    const double theta = kPi * i / (kParallels + 1);
    hoop(radius * std::sin(theta), radius * std::cos(theta), Matrix(1));
  }
  return mesh;
}

/// A pillar of four lobes that turns by half as it rises.
Mesh turned_pillar(double radius, double height) {
  return surface(
      [&](double u, double v) {
        const double a = 2 * kPi * u, r = radius * (1 - 0.3 * v) * (1 + 0.24 * std::cos(4 * a));
        const double b = a + kPi * 0.9 * v * (2 - v) / 1.0;
        return Vec3(r * std::cos(b), r * std::sin(b), -0.01 + (height + 0.01) * v);
      },
      96, 64, true, false);
}

/// The pillar's end: a fan over its last ring.
Mesh pillar_head(const Mesh& pillar, int around, double height) {
  Mesh mesh;
  const std::size_t first = pillar.positions.size() - around;
  for (int i = 0; i < around; ++i)
    mesh.triangle(Vec3(0, 0, height), pillar.positions[first + i],
                  pillar.positions[first + (i + 1) % around]);
  return mesh;
}
}  // namespace

void add_sculptures(Assembly& scene) {
  Model knot;
  knot.add("cream", drum(0.4, 0.62, 96));
  knot.add("petrol",
           closed_tube([](double t) { return torus_knot(t, 2, 3, 0.33, 0.165); },
                       [](double, double) { return 0.088; }, 320, 32),
           translate(0, 0, 0.62 + 0.488) * rotate_x(90) * rotate_z(90));
  scene.add("knot", knot, translate(0.3, -0.15, 0) * rotate_z(20), kCrease);

  Model globe;
  globe.add("ochre", cage(0.4, 0.0095));
  scene.add("cage", globe, translate(1.55, -0.75, 0.405) * rotate_z(20) * rotate_y(24), kCrease);

  Model pillar;
  const Mesh body = turned_pillar(0.21, 1.05);
  pillar.add("plum", body);
  pillar.add("plum", pillar_head(body, 96, 1.04));
  scene.add("pillar", pillar, translate(2.55, 0.85, 0.94) * rotate_z(15), kCrease);

  Model dish;
  dish.add("slate", gadrooned_bowl(0.34, 0.24, 14, 168));
  scene.add("bowl", dish, translate(0.55, -1.3, 0), kCrease);
}

void add_branch(Assembly& scene) {
  constexpr double kHeight = 0.56;
  std::vector<Vec2> profile =
      smooth({{0.11, 0}, {0.19, 0.1}, {0.215, 0.24}, {0.15, 0.41}, {0.07, 0.5}, {0.085, kHeight}}, 8);
  profile.insert(profile.begin(), Vec2(0, 0));
  Profile lip(profile.back().x, profile.back().y);
  lip.curve(-0.014, 0, 1, 5).to(0.058, 0.5).to(0.06, 0.4);
  profile.insert(profile.end(), lip.points().begin() + 1, lip.points().end());
  Model vase;
  vase.add("cream", lathe(profile, 128, [](double angle, double z) {
             const double depth = z < 0.44 ? 0.03 * std::min(1.0, (0.44 - z) / 0.1) : 0.0;
             return 1 + depth * std::abs(std::cos(12 * angle));
           }));
  // Stems that lean out of the vase, with leaves in pairs.
  const Dice dice(310);
  Mesh wood, leaves;
  for (int s = 0; s < 7; ++s) {
    const double a = 2 * kPi * s / 7 + dice.between(-0.3, 0.3, s), lean = dice.between(0.25, 0.75, s, 1);
    const double length = dice.between(0.75, 1.15, s, 2);
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const std::vector<Vec3> stem =
        smooth(std::vector<Vec3>{0.02 * out + Vec3(0, 0, 0.3), 0.035 * out + Vec3(0, 0, 0.55),
                                 (0.3 * lean * length) * out + Vec3(0, 0, 0.5 + 0.5 * length),
                                 (lean * length) * out + Vec3(0, 0, 0.5 + (1 - 0.35 * lean) * length)},
               8);
    std::vector<double> radii;
    for (std::size_t i = 0; i < stem.size(); ++i) radii.push_back(0.007 - 0.005 * i / stem.size());
    wood.append(tube(stem, radii, 7));
    for (std::size_t i = 9; i < stem.size(); ++i) {
      const Vec3 ahead = glm::normalize(stem[i] - stem[i - 1]);
      for (int k = 0; k < 2; ++k) {
        const double b = 2.1 * i + kPi * k + dice.between(-0.3, 0.3, s * 64 + i, 4 + k);
        const Vec3 side = glm::normalize(glm::cross(ahead, Vec3(std::cos(b), std::sin(b), 0.3)));
        const Vec3 way = glm::normalize(side + 0.55 * ahead),
                   across = glm::normalize(glm::cross(way, Vec3(0, 0, 1)));
        const Vec3 face = glm::cross(across, way), base = stem[i];
        const double size = dice.between(0.12, 0.18, s * 64 + i, 6 + k), width = 0.24 * size;
        leaves.append(surface(
            [&](double u, double v) {
              const double w = width * std::sin(kPi * std::pow(v, 0.8)), x = 2 * u - 1;
              return base + way * (size * v) + across * (w * x) +
                     face * (0.25 * w * x * x - 0.16 * size * v * v);
            },
            2, 6, false, false));
      }
    }
  }
  vase.add("bark", wood);
  vase.add("olive", leaves);
  scene.add("branch", vase, translate(-1.62, -0.95, 0), kCrease);
}

}  // namespace capcon::scenes::studio
