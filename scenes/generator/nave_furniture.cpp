#include <array>
#include <cmath>

#include "generator/nave.h"
#include "generator/nave_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::church {

namespace {
/// A pew along y, 2.9 long, looking east (+x), round the origin.
Model pew() {
  Model model;
  Mesh mesh;
  constexpr double kHalf = 1.45;
  mesh.append(bevelled_box(Vec3(-0.2, -kHalf, 0.43), Vec3(0.22, kHalf, 0.47), 0.008));
  mesh.append(box(Vec3(0.12, -kHalf, 0.12), Vec3(0.15, kHalf, 0.435), kEast | kWest | kBottom));
  mesh.append(bevelled_box(Vec3(-0.02, -kHalf, -0.04), Vec3(0.02, kHalf, 0.42), 0.006),
              translate(-0.24, 0, 0.5) * rotate_y(-8));
  mesh.append(bevelled_box(Vec3(-0.045, -kHalf, 0.4), Vec3(0.045, kHalf, 0.45), 0.012),
              translate(-0.24, 0, 0.5) * rotate_y(-8));
  mesh.append(box(Vec3(-0.48, -kHalf, 0.6), Vec3(-0.31, kHalf, 0.63), kAllFaces));
  for (const double y : {-kHalf - 0.03, kHalf + 0.03}) {
    mesh.append(box(Vec3(-0.32, y - 0.03, 0), Vec3(0.24, y + 0.03, 0.5), kAllFaces & ~kBottom));
    mesh.append(bevelled_box(Vec3(-0.36, y - 0.032, 0.45), Vec3(-0.2, y + 0.032, 0.99), 0.012));
    mesh.append(bevelled_box(Vec3(-0.36, y - 0.045, -0.005), Vec3(0.28, y + 0.045, 0.07), 0.01));
  }
  model.add("timber", mesh);
  return model;
}

Mesh candlestick(double height) {
  const double h = height;
  return lathe({{0.09, 0},
                {0.09, 0.02},
                {0.05, 0.05},
                {0.02, 0.1},
                {0.03, 0.14},
                {0.018, 0.18},
                {0.018, 0.5 * h},
                {0.035, 0.54 * h},
                {0.016, 0.58 * h},
                {0.02, 0.68 * h},
                {0.06, 0.71 * h},
                {0.06, 0.725 * h},
                {0.02, 0.73 * h},
                {0.02, h},
                {0.0, h + 0.005}},
               12);
}

Model altar() {
  Model model;
  const double z = kPlatform - 0.01;
  model.add("stone", bevelled_box(Vec3(-0.75, -1.5, z), Vec3(0.55, 1.5, z + 0.16), 0.015));
  model.add("stone", bevelled_box(Vec3(-0.32, -1.05, z + 0.15), Vec3(0.32, 1.05, z + 1.1), 0.02));
  model.add("stone", bevelled_box(Vec3(-0.42, -1.2, z + 1.08), Vec3(0.42, 1.2, z + 1.2), 0.025));
  for (const double y : {-0.72, 0.0, 0.72}) {
    model.add("wall", bevelled_box(Vec3(-0.35, y - 0.26, z + 0.28), Vec3(-0.3, y + 0.26, z + 0.98), 0.018));
  }
  for (const double y : {-0.95, -0.65, 0.65, 0.95})
    model.add("iron", candlestick(0.6), translate(0.1, y, z + 1.2));
  model.add("iron", bevelled_box(Vec3(0.08, -0.02, z + 1.19), Vec3(0.12, 0.02, z + 2.1), 0.005));
  model.add("iron", bevelled_box(Vec3(0.082, -0.28, z + 1.72), Vec3(0.118, 0.28, z + 1.76), 0.005));
  return model;
}

/// A hanging ring of candles; the chain ends at the origin, `drop` above the ring.
Model chandelier(double drop) {
  Model model;
  std::vector<Frame> ring;
  constexpr int kSegments = 32;
  for (int k = 0; k < kSegments; ++k) {
    const double a = -2 * kPi * k / kSegments;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    ring.push_back({0.8 * out - Vec3(0, 0, drop), out, Vec3(0, 0, 1)});
  }
  model.add("iron", sweep({{-0.015, -0.06}, {0.015, -0.06}, {0.015, 0.06}, {-0.015, 0.06}}, true, ring,
                          Ends::closed_loop));
  for (int k = 0; k < 12; ++k) {
    const Matrix here = rotate_z(30.0 * k) * translate(0.8, 0, -drop);
    model.add("candle", lathe({{0.0, 0.05}, {0.02, 0.05}, {0.02, 0.25}, {0.0, 0.26}}, 8), here);
    model.add("iron", lathe({{0.02, 0.04}, {0.06, 0.055}, {0.06, 0.065}, {0.02, 0.07}}, 10), here);
  }
  for (int k = 0; k < 4; ++k) {
    const Vec3 end = apply(rotate_z(90.0 * k + 15), Vec3(0.8, 0, -drop + 0.05));
    model.add("iron", tube({end, Vec3(0, 0, -drop + 1.3)}, {0.008, 0.008}, 5));
  }
  model.add("iron", tube({Vec3(0, 0, -drop + 1.25), Vec3(0, 0, 0.05)}, {0.012, 0.012}, 6));
  return model;
}
}  // namespace

void add_floor(Assembly& scene) {
  Model floor;
  const Dice dice(201);
  const double x1 = kLength + 0.5;
  const int nx = 26, ny = 16;
  const double dx = x1 / nx, dy = 2 * kAisle / ny;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const double x = i * dx, y = -kAisle + j * dy, g = 0.003, z = dice.between(-0.003, 0, j * nx + i);
      const std::array<Vec3, 4> top = {Vec3(x + g, y + g, z), Vec3(x + dx - g, y + g, z),
                                       Vec3(x + dx - g, y + dy - g, z), Vec3(x + g, y + dy - g, z)};
      floor.add((i + j) % 2 ? "tile-dark" : "tile-light", paving_stone(top, -0.03, 0.005));
    }
  }
  floor.add("wall", box(Vec3(-0.1, -kAisle - 0.1, -0.1), Vec3(x1 + 5, kAisle + 0.1, -0.025), kTop));
  scene.add("floor", std::move(floor));
}

void add_furniture(Assembly& scene) {
  scene.define("pew", pew());
  for (int row = 0; row < 10; ++row) {
    for (const double y : {-2.25, 2.25}) scene.place("pew", translate(7.2 + 1.35 * row, y, 0));
  }
  scene.add("altar", altar(), translate(kApse + 1.4, 0, 0));
  scene.define("chandelier", chandelier(8.6));
  for (const int bay : {2, 5}) scene.place("chandelier", translate(bay_centre(bay), 0, 15.5));
}

}  // namespace capcon::scenes::church
