#include <algorithm>
#include <cmath>

#include "generator/atelier.h"
#include "generator/solids.h"
#include "generator/surfaces.h"

namespace capcon::scenes::studio {

namespace {
constexpr double kCrease = 40;

/// One leaf of a folding screen in the plane y = 0, from x = 0 to `width`, with laths on both diagonals.
Model screen_leaf(double width, double height) {
  constexpr double kFrame = 0.045, kThick = 0.02, kPitch = 0.125, kLath = 0.009;
  Model model;
  const auto bar = [&](double x0, double z0, double x1, double z1) {
    model.add("sage", bevelled_box(Vec3(x0, -kThick, z0), Vec3(x1, kThick, z1), 0.006));
  };
  bar(0, 0.002, kFrame, height);
  bar(width - kFrame, 0.002, width, height);
  for (const double z : {0.09, 0.62 * height, height - kFrame - 0.01})
    bar(kFrame - 0.004, z, width - kFrame + 0.004, z + kFrame);
  const double x0 = kFrame - 0.003, x1 = width - kFrame + 0.003, z0 = 0.12, z1 = height - kFrame;
  for (const int slope : {1, -1}) {
    // Lines z = slope x + c, cut to the frame.
    const double low = slope > 0 ? z0 - x1 : z0 + x0, high = slope > 0 ? z1 - x0 : z1 + x1;
    for (double c = low + 0.06; c < high - 0.03; c += kPitch) {
      const auto x_at = [&](double z) { return (z - c) * slope; };
      const double a = std::max(x0, std::min(x_at(z0), x_at(z1)));
      const double b = std::min(x1, std::max(x_at(z0), x_at(z1)));
      if (b - a < 0.03) continue;
      const double length = (b - a) * std::sqrt(2.0), y = 0.0045 * slope;  // one layer before the other
      model.add("sage", box(Vec3(0, -0.005, -kLath), Vec3(length, 0.005, kLath)),
                translate(a, y, slope * a + c) * rotate_y(-45.0 * slope));
    }
  }
  return model;
}

/// A thin lens in the plane y = 0, its upper end at the origin.
Mesh petal(double length, double width) {
  Mesh lens = ball([](const Vec3& d) { return 1 + 0.22 * d.z; }, 40, 22);
  Mesh mesh;
  mesh.append(lens, translate(0, 0, -0.5 * length) * scale(0.5 * width, 0.008, 0.5 * length / 1.0));
  return mesh;
}
}  // namespace

void add_screen(Assembly& scene) {
  constexpr double kWidth = 0.66, kHeight = 1.95;
  scene.define("screen", screen_leaf(kWidth, kHeight), kCrease);
  Matrix hinge = translate(-2.98, 0.75, 0);
  for (const double turn : {-34.0, 26.0, -30.0}) {
    const Matrix leaf = hinge * rotate_z(turn);
    scene.place("screen", leaf);
    hinge = hinge * translate(apply(rotate_z(turn), Vec3(kWidth + 0.012, 0, 0)));
  }
}

void add_mobile(Assembly& scene) {
  // Arms in balance, each hung from the one above: a petal on one side, the next arm on the other.
  struct Arm {
    double turn, petal_side, arm_side, drop;
    double length, width;
    const char* material;
  };
  constexpr Arm kArms[] = {
      {15, 0.95, 0.42, 0.30, 0.52, 0.34, "vermilion"}, {-28, 0.72, 0.40, 0.24, 0.44, 0.28, "ink"},
      {32, 0.60, 0.36, 0.22, 0.38, 0.25, "ochre"},     {-20, 0.48, 0.33, 0.20, 0.33, 0.22, "vermilion"},
      {40, 0.36, 0.30, 0.18, 0.28, 0.19, "cream"},     {5, 0.27, 0.24, 0.15, 0.24, 0.16, "petrol"}};
  Model model;
  Vec3 pivot(0, 0, 0);
  Mesh wire = tube({{0, 0, 2.6}, {0, 0, 0}}, {0.004, 0.004}, 6);
  int side = 1;
  for (const Arm& arm : kArms) {
    const Matrix turn = rotate_z(arm.turn);
    const auto at = [&](double along, double up) { return pivot + apply(turn, Vec3(side * along, 0, up)); };
    std::vector<Vec3> curve;
    for (int i = 0; i <= 16; ++i) {
      const double t = i / 16.0, along = -arm.arm_side + t * (arm.arm_side + arm.petal_side);
      curve.push_back(at(along, -0.22 * along * along));
    }
    wire.append(tube(curve, std::vector<double>(curve.size(), 0.0055), 6));
    const Vec3 end = curve.back(), other = curve.front();
    wire.append(tube({end + Vec3(0, 0, 0.003), end - Vec3(0, 0, 0.06)}, {0.003, 0.003}, 6));
    model.add(arm.material, petal(arm.length, arm.width),
              translate(end - Vec3(0, 0, 0.055)) * rotate_z(0.7 * arm.turn - 20));
    const Vec3 next = other - Vec3(0, 0, arm.drop);
    wire.append(tube({other + Vec3(0, 0, 0.003), next}, {0.003, 0.003}, 6));
    pivot = next;
    side = -side;
  }
  model.add("vermilion", petal(0.3, 0.2), translate(pivot + Vec3(0, 0, 0.01)) * rotate_z(-40));
  model.add("ink", wire);
  scene.add("mobile", model, translate(1.15, 2.1, 3.15) * scale(0.78, 0.78, 0.78), kCrease);
}

}  // namespace capcon::scenes::studio
