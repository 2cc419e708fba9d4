#include <cmath>

#include "generator/nave.h"
#include "generator/nave_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::church {

namespace {
/// One shaft with base and capital from `foot` to `head`.
Mesh shaft(double radius, double foot, double head, int segments) {
  const double r = radius, capital = std::min(2.6 * r, 0.42);
  Profile p(0.0, foot - 0.01);
  p.to(1.7 * r, foot - 0.01)
      .to(1.7 * r, foot + 0.3 * r)
      .curve(-0.1 * r, 0.4 * r, 0.8, 2)
      .curve(-0.3 * r, 0.3 * r, -0.4, 1)
      .curve(-0.3 * r, 0.3 * r, 0.5, 2);
  p.to(r, head - capital).by(0.24 * r, 0.03 * capital).by(-0.22 * r, 0.08 * capital);
  p.curve(0.64 * r, 0.66 * capital, -0.3, 3).by(0.03, 0).by(0, 0.08 * capital);
  return lathe(p.points(), segments);
}

/// An octagonal slab, for plinths and abaci, with a moulded edge: wider at the bottom (`flare` > 0) or at the
/// top.
Mesh octagon(double radius, double foot, double head, double flare) {
  const double h = head - foot;
  Profile p(0.0, foot);
  p.to(radius + std::max(0.0, flare), foot)
      .by(0, 0.45 * h)
      .by(-flare, 0.3 * h)
      .by(0, 0.25 * h - 0.01)
      .by(-0.01, 0.01);
  p.to(0.0, head);
  return lathe(p.points(), 8);
}

/// A core with eight shafts about it, from the floor to kCapital.
Model pier() {
  Model model;
  Mesh mesh;
  mesh.append(octagon(0.66, -0.02, 0.3, 0.06), rotate_z(22.5));
  mesh.append(lathe({{0.42, 0.25}, {0.42, kCapital - 0.1}}, 16), rotate_z(11.25));
  const Mesh major = shaft(0.15, 0.3, kCapital - 0.14, 10), minor = shaft(0.1, 0.3, kCapital - 0.14, 6);
  for (int k = 0; k < 4; ++k) {
    mesh.append(major, rotate_z(90.0 * k) * translate(0.45, 0, 0));
    mesh.append(minor, rotate_z(90.0 * k + 45) * translate(0.43, 0, 0));
  }
  mesh.append(octagon(0.62, kCapital - 0.16, kCapital, -0.1), rotate_z(22.5));
  model.add("stone", mesh);
  return model;
}

/// Shafts on the wall above a pier that carry the high vault; the wall's face is y = 0, the nave at y < 0.
Model responds(double foot) {
  Model model;
  Mesh mesh;
  mesh.append(shaft(0.14, foot, kTriforiumHead - 0.13, 10), translate(0, -0.1, 0));
  for (const double x : {-0.27, 0.27})
    mesh.append(shaft(0.09, foot, kTriforiumHead - 0.13, 6), translate(x, -0.04, 0));
  mesh.append(octagon(0.4, kTriforiumHead - 0.15, kTriforiumHead, -0.08),
              translate(0, -0.02, 0) * rotate_z(22.5));
  model.add("stone", mesh);
  return model;
}

/// Shafts on an aisle's outer wall, its face at y = 0.
Model aisle_responds() {
  Model model;
  Mesh mesh;
  mesh.append(octagon(0.34, -0.02, 0.3, 0.05), rotate_z(22.5));
  mesh.append(shaft(0.14, 0.3, kCapital - 0.13, 10), translate(0, -0.12, 0));
  for (const double x : {-0.24, 0.24})
    mesh.append(shaft(0.08, 0.3, kCapital - 0.13, 6), translate(x, -0.05, 0));
  mesh.append(octagon(0.36, kCapital - 0.15, kCapital, -0.08), translate(0, -0.02, 0) * rotate_z(22.5));
  model.add("stone", mesh);
  return model;
}
}  // namespace

void add_piers(Assembly& scene) {
  scene.define("pier", pier());
  scene.define("responds", responds(kCapital + 0.02));
  scene.define("aisle-responds", aisle_responds());
  for (const bool north : {true, false}) {
    for (int i = 0; i <= kBays; ++i) {
      const Matrix here = wall_frame(north) * translate(kBay * i, 0, 0);
      scene.place("pier", here * translate(0, 0.5 * kThick, 0));
      scene.place("responds", here);
      scene.place("aisle-responds", here * translate(0, kAisle - kFace, 0));
    }
  }
}

}  // namespace capcon::scenes::church
