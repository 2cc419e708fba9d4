#include "generator/masonry.h"

#include <cmath>

#include "generator/solids.h"

namespace capcon::scenes {

Mesh voussoirs(double radius, double depth, double out, int count, double z) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const bool key = i == count / 2;
    const double joint = 0.004 / radius, step = kPi / count;
    const double a0 = kPi - i * step - joint, a1 = kPi - (i + 1) * step + joint;
    const double inner = radius + (key ? -0.02 : 0.006),
                 outer = radius + depth + (key ? 0.08 : (i % 2) * 0.03);
    const double top = out * (key ? 1.9 : 1);
    const auto corner = [&](double a, double r) { return Vec3(r * std::cos(a), z + r * std::sin(a), top); };
    mesh.append(paving_stone({corner(a0, inner), corner(a1, inner), corner(a1, outer), corner(a0, outer)},
                             -0.01, 0.008));
  }
  Mesh upright;
  upright.append(mesh, rotate_x(90));
  return upright;
}

Profile foot_rail() {
  Profile p(-0.11, -0.01);
  p.by(0.22, 0).by(0, 0.1).by(-0.03, 0.02).by(-0.16, 0).by(-0.03, -0.02).by(0, -0.1);
  return p;
}

Profile hand_rail(double z) {
  Profile p(-0.1, z);
  p.by(0.2, 0).by(0, 0.02).curve(0.03, 0.03, -0.3, 3).by(0.02, 0).by(0, 0.04).by(-0.01, 0.02);
  p.by(-0.28, 0).by(-0.01, -0.02).by(0, -0.04).by(0.02, 0).curve(0.03, -0.03, -0.3, 3).by(0, -0.02);
  return p;
}

Mesh newel(double height, double half) {
  const double h = half;
  Mesh mesh = box(Vec3(-h, -h, -0.02), Vec3(h, h, height - 0.1), kUpright);
  mesh.append(bevelled_box(Vec3(-h - 0.04, -h - 0.04, -0.02), Vec3(h + 0.04, h + 0.04, 0.16), 0.012));
  mesh.append(bevelled_box(Vec3(-h - 0.025, -h - 0.025, height - 0.13),
                           Vec3(h + 0.025, h + 0.025, height - 0.085), 0.01));
  mesh.append(
      bevelled_box(Vec3(-h - 0.05, -h - 0.05, height - 0.09), Vec3(h + 0.05, h + 0.05, height), 0.015));
  Profile ball(0.09, height - 0.01);
  ball.by(0, 0.03).curve(-0.04, 0.05, -0.4, 4).curve(-0.049, 0.22, 1.6, 14).to(0, height + 0.292);
  mesh.append(lathe(ball.points(), 24));
  return mesh;
}

}  // namespace capcon::scenes
