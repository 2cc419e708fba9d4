#include "generator/foliage.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

void add_leaf(Mesh& mesh, const Vec3& base, const Vec3& direction, const Vec3& up, double length,
              double width) {
  const Vec3 d = glm::normalize(direction);
  Vec3 side = glm::cross(d, up);
  if (glm::length(side) < 1e-3) side = glm::cross(d, Vec3(0.6, 0.8, 0.1));
  side = glm::normalize(side);
  const Vec3 n = glm::cross(side, d);
  const std::uint32_t foot = mesh.vertex(base), middle = mesh.vertex(base + d * (0.45 * length));
  const std::uint32_t left =
      mesh.vertex(base + d * (0.42 * length) - side * (0.5 * width) + n * (0.18 * width));
  const std::uint32_t right =
      mesh.vertex(base + d * (0.42 * length) + side * (0.5 * width) + n * (0.18 * width));
  const std::uint32_t tip = mesh.vertex(base + d * length - n * (0.22 * length));
  mesh.triangle(foot, right, middle);
  mesh.triangle(foot, middle, left);
  mesh.triangle(middle, right, tip);
  mesh.triangle(middle, tip, left);
}

namespace {
/// A direction evenly on the sphere.
Vec3 direction(const Dice& dice, std::uint64_t i, std::uint64_t k) {
  const double z = dice.between(-1, 1, i, k), a = dice.between(0, 2 * kPi, i, k + 1),
               r = std::sqrt(1 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}

/// A bent branch from a to b.
void add_branch(Mesh& mesh, const Vec3& a, const Vec3& b, double r0, double r1, const Vec3& bend, int sides) {
  const std::vector<Vec3> points = smooth(std::vector<Vec3>{a, 0.5 * (a + b) + bend, b}, 3);
  std::vector<double> radii;
  for (std::size_t i = 0; i < points.size(); ++i) radii.push_back(r0 + (r1 - r0) * i / (points.size() - 1.0));
  mesh.append(tube(points, radii, sides));
}
}  // namespace

Model orange_tree(double height, int leaves, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh wood, crown, fruit;
  const double fork = 0.42 * height, spread = 0.36 * height;
  const Vec3 centre(0, 0, 0.7 * height), stretch(spread, spread, 0.32 * height), top(0.03, -0.02, fork);
  const std::vector<Vec3> trunk =
      smooth(std::vector<Vec3>{{0, 0, -0.05}, {0.02, 0.015, 0.08}, {-0.02, 0.02, 0.5 * fork}, top}, 4);
  std::vector<double> radii;
  for (std::size_t i = 0; i < trunk.size(); ++i)
    radii.push_back(0.075 - 0.025 * std::min(1.0, i / 6.0) - 0.006 * i / trunk.size());
  wood.append(tube(trunk, radii, 10));
  // Boughs reach for points inside the crown; twigs from them to its skin; leaves grow round the twigs' outer
  // ends.
  std::vector<Vec3> ends;
  constexpr int kBoughs = 7, kTwigs = 9;
  for (int b = 0; b < kBoughs; ++b) {
    const double a = 2 * kPi * (b + dice.between(-0.25, 0.25, b)) / kBoughs,
                 up = dice.between(-0.35, 0.6, b, 1);
    const Vec3 reach = centre + stretch * Vec3(0.55 * std::cos(a), 0.55 * std::sin(a), up);
    add_branch(wood, top - Vec3(0, 0, 0.03), reach, 0.032, 0.014, Vec3(0, 0, -0.06), 6);
    for (int t = 0; t < kTwigs; ++t) {
      Vec3 out = direction(dice, 100 + b * kTwigs + t, 0);
      out += 0.9 * glm::normalize((reach - centre) / stretch);
      const Vec3 skin =
          centre + stretch * glm::normalize(out) * dice.between(0.72, 0.97, 100 + b * kTwigs + t, 2);
      add_branch(wood, reach, skin, 0.011, 0.004, 0.05 * direction(dice, 100 + b * kTwigs + t, 3), 4);
      ends.push_back(skin);
      ends.push_back(0.45 * reach + 0.55 * skin);
    }
  }
  for (int i = 0; i < leaves; ++i) {
    const Vec3 end = ends[static_cast<std::size_t>(dice.between(0, ends.size() - 1e-6, 1000 + i))];
    const Vec3 offset =
        direction(dice, 1000 + i, 1) * (0.24 * std::cbrt(dice.between(0, 1, 1000 + i, 3)) * height / 3);
    const Vec3 outward = glm::normalize(end + offset - centre);
    add_leaf(crown, end + offset, outward + direction(dice, 1000 + i, 4) + Vec3(0, 0, -0.25),
             outward + Vec3(0, 0, 0.8), dice.between(0.075, 0.12, 1000 + i, 6),
             dice.between(0.035, 0.055, 1000 + i, 7));
  }
  std::vector<Vec2> ball;
  for (int i = 0; i <= 6; ++i)
    ball.emplace_back(0.038 * std::sin(kPi * i / 6), -0.038 * std::cos(kPi * i / 6));
  ball.front().x = ball.back().x = 0;
  for (int i = 0; i < 42; ++i) {
    const Vec3 where = ends[(i * 37) % ends.size()] + 0.12 * direction(dice, 50000 + i, 0) - Vec3(0, 0, 0.07);
    fruit.append(lathe(ball, 10), translate(where));
  }
  Model model;
  model.add("bark", wood);
  model.add("leaf", crown);
  model.add("fruit", fruit);
  return model;
}

Model shrub(double radius, int leaves, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh wood, green;
  for (int i = 0; i < 14; ++i) {
    Vec3 d = direction(dice, i, 0);
    d.z = std::abs(d.z) + 0.3;
    const Vec3 end = glm::normalize(d) * (0.8 * radius) + Vec3(0, 0, 0.35 * radius);
    add_branch(wood, Vec3(0, 0, -0.03), end, 0.009, 0.003, 0.05 * direction(dice, i, 2), 4);
  }
  for (int i = 0; i < leaves; ++i) {
    Vec3 d = direction(dice, 100 + i, 0);
    d.z = std::max(d.z, -0.35 + 0.3 * d.z);
    const double r = radius * (0.55 + 0.45 * std::sqrt(dice.between(0, 1, 100 + i, 2))) *
                     (1 + 0.08 * std::sin(5 * d.x + 7 * d.y));
    const Vec3 p = d * r + Vec3(0, 0, 0.55 * radius);
    add_leaf(green, p, d + 0.9 * direction(dice, 100 + i, 3), d + Vec3(0, 0, 0.7),
             dice.between(0.05, 0.08, 100 + i, 5), dice.between(0.025, 0.038, 100 + i, 6));
  }
  Model model;
  model.add("bark", wood);
  model.add("leaf", green);
  return model;
}

Model cypress(double height, int leaves, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh wood, green;
  wood.append(tube({Vec3(0, 0, -0.05), Vec3(0.01, 0, 0.4 * height), Vec3(0, 0, 0.9 * height)},
                   {0.06, 0.04, 0.008}, 8));
  for (int i = 0; i < leaves; ++i) {
    const double t = dice.between(0.0, 1.0, i), a = dice.between(0, 2 * kPi, i, 1);
    // Widest at a third of its height, pointed at the top, with furrows between its upright boughs.
    const double girth = 0.095 * height * std::pow(std::sin(kPi * std::pow(t, 0.62) * 0.985 + 0.035), 0.8);
    const double r =
        girth * (0.62 + 0.38 * std::sqrt(dice.between(0, 1, i, 2))) * (1 + 0.1 * std::sin(6 * a + 9 * t));
    const Vec3 out(std::cos(a), std::sin(a), 0);
    add_leaf(green, out * r + Vec3(0, 0, 0.25 + (height - 0.25) * t),
             0.55 * out + Vec3(0, 0, 1) + 0.35 * direction(dice, i, 3), out, dice.between(0.1, 0.17, i, 5),
             dice.between(0.03, 0.05, i, 6));
  }
  Model model;
  model.add("bark", wood);
  model.add("leaf", green);
  return model;
}

}  // namespace capcon::scenes
