#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "generator/foliage.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

Model geranium(std::uint64_t stream) {
  const Dice dice(stream);
  Mesh green, petals;
  for (int s = 0; s < 26; ++s) {
    const double a = 2.39996 * s, lean = dice.between(0.1, 0.95, s), length = dice.between(0.13, 0.3, s, 1);
    const Vec3 out(std::cos(a), std::sin(a), 0), foot = 0.06 * out * dice.between(0, 1, s, 2);
    const Vec3 end = foot + length * glm::normalize(lean * out + Vec3(0, 0, 1.0));
    green.append(tube({foot - Vec3(0, 0, 0.02), end}, {0.004, 0.003}, 4));
    for (int l = 0; l < 9; ++l) {
      const double b = 2 * kPi * l / 9 + s, t = 0.35 + 0.65 * l / 9.0;
      const Vec3 d(std::cos(b), std::sin(b), dice.between(-0.3, 0.5, s, 8 + l));
      add_leaf(green, foot + t * (end - foot), d + 0.4 * out, Vec3(0, 0, 1),
               dice.between(0.05, 0.085, s, 20 + l), 0.06);
    }
    if (s % 3 != 0) continue;
    const Vec3 head = end + Vec3(0, 0, 0.07);
    green.append(tube({end, head}, {0.003, 0.0025}, 4));
    for (int f = 0; f < 22; ++f) {
      const double z = 1 - 1.6 * (f + 0.5) / 22, b = 2.39996 * f, r = std::sqrt(1 - z * z);
      const Vec3 d(r * std::cos(b), r * std::sin(b), z);
      add_leaf(petals, head + 0.012 * d, d, Vec3(-d.y, d.x, 0.3), 0.032, 0.026);
    }
  }
  Model model;
  model.add("leaf", green);
  model.add("flower", petals);
  return model;
}

Model agave(double size, int blades, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh green;
  constexpr int kSteps = 6;
  for (int b = 0; b < blades; ++b) {
    const double a = 2.39996 * b,
                 age = static_cast<double>(blades - b) / blades;  // the outer blades come first
    const double lift = 1.35 - 1.05 * age + dice.between(-0.1, 0.1, b),
                 length = size * dice.between(0.85, 1.05, b, 1);
    const Vec3 out(std::cos(a), std::sin(a), 0), side(-out.y, out.x, 0);
    std::vector<std::uint32_t> left, middle, right;
    Vec3 p = 0.05 * size * out;
    double pitch = lift;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps,
                   width = 0.075 * size * (0.55 + 1.3 * t) * (1 - t) + 0.002;
      const Vec3 normal = -std::sin(pitch) * out + Vec3(0, 0, std::cos(pitch));
      left.push_back(green.vertex(p + width * side + 0.6 * width * normal));
      middle.push_back(green.vertex(p));
      right.push_back(green.vertex(p - width * side + 0.6 * width * normal));
      p += length / kSteps * (std::cos(pitch) * out + Vec3(0, 0, std::sin(pitch)));
      pitch -= 0.09 * age + 0.03;
    }
    for (int i = 0; i < kSteps; ++i) {
      green.quad(middle[i], middle[i + 1], left[i + 1], left[i]);
      green.quad(right[i], right[i + 1], middle[i + 1], middle[i]);
    }
  }
  Model model;
  model.add("leaf", green);
  return model;
}

Model climber(double width, double height, int leaves, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh wood, green;
  constexpr int kStems = 9, kKnots = 9;
  std::vector<std::vector<Vec3>> stems;
  for (int s = 0; s < kStems; ++s) {
    std::vector<Vec3> knots;
    const double reach = height * dice.between(0.55, 1.0, s), aim = width * ((s + 0.5) / kStems - 0.5);
    for (int k = 0; k <= kKnots; ++k) {
      const double t = static_cast<double>(k) / kKnots, wander = 0.09 * width * std::min(1.0, 3 * t);
      knots.emplace_back(aim * std::min(1.0, 0.12 + 1.7 * t) + dice.between(-wander, wander, s, 1 + k), -0.02,
                         reach * t);
    }
    stems.push_back(smooth(knots, 3));
    std::vector<double> radii;
    for (std::size_t i = 0; i < stems.back().size(); ++i)
      radii.push_back(0.014 - 0.011 * i / stems.back().size());
    wood.append(tube(stems.back(), radii, 4));
  }
  for (int i = 0; i < leaves; ++i) {
    const auto& stem = stems[i % kStems];
    const double t = std::pow(dice.between(0.0, 1.0, 100 + i), 0.75);
    const Vec3 on = stem[static_cast<std::size_t>(t * (stem.size() - 1))];
    const double reach = 0.05 + 0.5 * width / kStems * dice.between(0.3, 1.6, 100 + i, 1),
                 a = dice.between(0, 2 * kPi, 100 + i, 2);
    const double depth = 0.02 + 0.11 * dice.between(0, 1, 100 + i, 3) * dice.between(0, 1, 100 + i, 4);
    const Vec3 p(on.x + reach * std::cos(a), -depth, std::max(0.04, on.z + reach * std::sin(a)));
    const Vec3 down(dice.between(-0.8, 0.8, 100 + i, 5), dice.between(-0.5, -0.05, 100 + i, 6),
                    -1 + dice.between(0, 0.5, 100 + i, 7));
    const double size = dice.between(0.07, 0.125, 100 + i, 8);
    add_leaf(green, p, down, Vec3(dice.between(-0.4, 0.4, 100 + i, 9), -1, 0.4), size, 0.85 * size);
  }
  Model model;
  model.add("bark", wood);
  model.add("ivy", green);
  return model;
}

Model canopy(double size, int leaves, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh wood, green, petals;
  for (int s = 0; s < 6; ++s) {
    std::vector<Vec3> knots;
    for (int k = 0; k <= 5; ++k) {
      const double across = size * (s + 0.5) / 6 + dice.between(-0.08, 0.08, s, k);
      const double along = size * k / 5, z = dice.between(0.01, 0.07, s, 10 + k);
      knots.push_back(s % 2 ? Vec3(across, along, z) : Vec3(along, across, z));
    }
    const std::vector<Vec3> stem = smooth(knots, 2);
    wood.append(tube(stem, std::vector<double>(stem.size(), 0.007), 4));
  }
  for (int i = 0; i < leaves; ++i) {
    const double x = dice.between(-0.05, size + 0.05, 100 + i),
                 y = dice.between(-0.05, size + 0.05, 100 + i, 1);
    const double hump = 0.1 + 0.06 * std::sin(9 * x + 1) * std::sin(8 * y + 2);
    const double z = dice.between(-0.1, 0.02, 100 + i, 2) + hump;
    const double a = dice.between(0, 2 * kPi, 100 + i, 3);
    const Vec3 d(std::cos(a), std::sin(a), dice.between(-0.9, 0.2, 100 + i, 4));
    const bool blossom = dice.between(0, 1, 100 + i, 5) < 0.18 && z > 0.03;
    const double length = blossom ? 0.05 : dice.between(0.07, 0.12, 100 + i, 6);
    add_leaf(blossom ? petals : green, Vec3(x, y, z), d, Vec3(0.3 * d.y, -0.3 * d.x, 1), length,
             0.8 * length);
  }
  Model model;
  model.add("bark", wood);
  model.add("ivy", green);
  model.add("flower", petals);
  return model;
}

}  // namespace capcon::scenes
