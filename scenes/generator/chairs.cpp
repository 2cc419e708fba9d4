#include "generator/chairs.h"

#include <cmath>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

Model round_table() {
  Model model;
  Profile top(0.05, 0.7);
  top.to(0.46, 0.705).curve(0, 0.035, 0.8, 5).to(0.0, 0.74);
  model.add("timber", lathe(top.points(), 48));
  Profile stem(0.045, 0.14);
  stem.by(0.015, 0)
      .curve(0, 0.03, 1, 4)
      .by(-0.025, 0.01)
      .to(0.028, 0.55)
      .by(0.02, 0.03)
      .curve(0, 0.03, 1, 4)
      .to(0.03, 0.66)
      .to(0.12, 0.703);
  model.add("iron", lathe(stem.points(), 16));
  for (int k = 0; k < 3; ++k) {
    const std::vector<Vec3> foot =
        smooth(std::vector<Vec3>{{0.02, 0, 0.2}, {0.14, 0, 0.17}, {0.25, 0, 0.06}, {0.36, 0, 0.018}}, 4);
    model.add("iron", tube(foot, std::vector<double>(foot.size(), 0.018), 8), rotate_z(120.0 * k + 20));
  }
  return model;
}

Model ladder_chair() {
  Model model;
  const auto bar = [&](const Vec3& a, const Vec3& b, double r) {
    model.add("timber", tube({a, 0.5 * (a + b), b}, {r, 1.12 * r, r}, 8));
  };
  constexpr double kW = 0.2, kSeat = 0.45;
  for (const double side : {-1.0, 1.0}) {
    bar(Vec3(side * (kW + 0.01), 0.19, 0), Vec3(side * kW, 0.18, kSeat + 0.02), 0.018);
    const std::vector<Vec3> post = smooth(
        std::vector<Vec3>{{side * 0.19, -0.22, 0}, {side * 0.18, -0.18, kSeat}, {side * 0.18, -0.27, 0.97}},
        4);
    model.add("timber", tube(post, std::vector<double>(post.size(), 0.018), 8));
    for (const double z : {0.14, 0.27})
      bar(Vec3(side * 0.195, -0.205, z), Vec3(side * 0.205, 0.185, z), 0.011);
  }
  for (const double z : {0.18, 0.3}) bar(Vec3(-0.2, 0.186, z), Vec3(0.2, 0.186, z), 0.011);
  bar(Vec3(-0.19, -0.2, 0.22), Vec3(0.19, -0.2, 0.22), 0.011);
  // Three bowed slats between the posts.
  for (int i = 0; i < 3; ++i) {
    const double z = 0.6 + 0.14 * i, back = -0.2 - 0.065 * (z - 0.45) / 0.5;
    std::vector<Frame> path;
    for (int k = 0; k <= 6; ++k) {
      const double t = k / 6.0;
      path.push_back({Vec3(-0.18 + 0.36 * t, back - 0.035 * std::sin(kPi * t), z + 0.012 * std::sin(kPi * t)),
                      Vec3(0, 1, 0), Vec3(0, 0, 1)});
    }
    model.add("timber", sweep({{-0.007, -0.035}, {0.007, -0.035}, {0.007, 0.035}, {-0.007, 0.035}}, true,
                              path, Ends::capped));
  }
  // A rush seat: strands from side to side and from front to back meet along the diagonals, which sink a
  // little.
  for (int k = 0; k < 4; ++k) {
    for (int strand = 0; strand < 9; ++strand) {
      const double inner = 0.012 + 0.0218 * strand;
      const double sag = 0.014 * (1 - inner / 0.2);
      model.add("straw",
                tube({Vec3(-inner, inner, kSeat - sag), Vec3(0, inner, kSeat + 0.006 - sag),
                      Vec3(inner, inner, kSeat - sag)},
                     {0.0125, 0.0125, 0.0125}, 6),
                translate(0, -0.005, 0) * rotate_z(90.0 * k));
    }
  }
  return model;
}

Model table_ware() {
  Model model;
  Profile carafe(0.0, 0.002), glass(0.0, 0.002), plate(0.0, 0.004);
  carafe.to(0.05, 0.002)
      .curve(0.005, 0.11, 0.25, 6)
      .curve(-0.035, 0.07, -0.2, 5)
      .by(0.012, 0.05)
      .by(-0.004, 0.002)
      .by(-0.012, -0.05);
  glass.to(0.028, 0.002).to(0.036, 0.09).by(-0.003, 0.001).to(0.026, 0.01);
  plate.to(0.06, 0.002)
      .curve(0.06, 0.016, 0.15, 4)
      .by(-0.003, 0.003)
      .curve(-0.05, -0.013, -0.1, 3)
      .to(0.0, 0.009);
  Mesh dish = lathe(plate.points(), 32);
  model.add("china", lathe(carafe.points(), 24), translate(0.03, 0.05, 0));
  for (int k = 0; k < 4; ++k) {
    const double a = 90.0 * k + 8;
    model.add("china", dish, rotate_z(a) * translate(0.3, 0, 0));
    model.add("china", lathe(glass.points(), 18), rotate_z(a + 28) * translate(0.22, 0, 0));
  }
  return model;
}

Model lantern() {
  Model model;
  for (int i = 0; i < 12; ++i) {  // the chain's links stand crosswise
    std::vector<Frame> ring;
    for (int k = 0; k < 10; ++k) {
      const double a = 2 * kPi * k / 10;
      const Vec3 out(std::cos(a) * 0.6, 0, std::sin(a));
      ring.push_back(
          {Vec3(0.022 * out.x, 0, 0.036 * out.z), Vec3(std::cos(a), 0, std::sin(a)), Vec3(0, -1, 0)});
    }
    for (Frame& frame : ring) frame.up = -frame.up;
    std::vector<Vec2> wire;
    for (int k = 0; k < 4; ++k)
      wire.emplace_back(0.006 * std::cos(kPi * k / 2), 0.006 * std::sin(kPi * k / 2));
    Mesh link = sweep(wire, true, ring, Ends::closed_loop);
    link.flip();
    model.add("iron", link, translate(0, 0, -0.03 - 0.056 * i) * rotate_z(90.0 * (i % 2)));
  }
  Profile roof(0.17, -0.82);
  roof.by(0.005, 0.012).curve(-0.115, 0.075, -0.2, 4).by(0, 0.012).curve(-0.045, 0.03, 0.3, 3).to(0.0, -0.69);
  model.add("iron", lathe(roof.points(), 6));
  model.add(
      "iron",
      lathe({{0.0, -1.125}, {0.02, -1.11}, {0.1, -1.09}, {0.12, -1.085}, {0.12, -1.07}, {0.0, -1.07}}, 6));
  for (int k = 0; k < 6; ++k) {
    const double a = kPi * k / 3;
    const Vec3 d(std::cos(a), std::sin(a), 0);
    model.add("iron",
              tube({0.112 * d + Vec3(0, 0, -1.075), 0.16 * d + Vec3(0, 0, -0.815)}, {0.008, 0.008}, 4));
  }
  model.add(
      "china",
      lathe({{0.0, -1.07}, {0.022, -1.069}, {0.022, -0.95}, {0.004, -0.945}, {0.004, -0.925}, {0.0, -0.924}},
            12));
  return model;
}

Model stone_bench() {
  Model model;
  model.add("stone", bevelled_box(Vec3(-0.75, -0.42, 0.4), Vec3(0.75, -0.015, 0.47), 0.012));
  for (const double x : {-0.5, 0.5}) {
    model.add("stone", bevelled_box(Vec3(x - 0.08, -0.36, -0.02), Vec3(x + 0.08, -0.06, 0.405), 0.02));
    model.add("stone", bevelled_box(Vec3(x - 0.11, -0.4, -0.02), Vec3(x + 0.11, -0.03, 0.07), 0.015));
  }
  return model;
}

}  // namespace capcon::scenes
