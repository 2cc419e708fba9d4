#include "generator/pots.h"

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

Pot flower_pot(double height) {
  const double h = height, r = 0.55 * h;
  Profile p(0.3 * r, 0.0);
  p.to(0.68 * r, 0.0)
      .to(0.92 * r, 0.78 * h)
      .by(0.06 * r, 0.005 * h)
      .to(1.02 * r, 0.97 * h)
      .curve(-0.09 * r, 0.03 * h, 0.3, 3);
  p.by(-0.06 * r, -0.03 * h).to(0.82 * r, 0.8 * h);
  Pot pot{{}, 0.86 * h};
  pot.model.add("pot", lathe(p.points(), 32));
  pot.model.add("earth", disc(0.86 * r, pot.soil, 24));
  return pot;
}

Pot urn(double height) {
  const double h = height, r = 0.42 * h;
  std::vector<Vec2> outer = {{0.2 * r, 0}, {0.62 * r, 0}, {0.62 * r, 0.05 * h}, {0.42 * r, 0.1 * h}};
  const std::vector<Vec2> belly = smooth({{0.42 * r, 0.1 * h},
                                          {0.72 * r, 0.28 * h},
                                          {0.98 * r, 0.55 * h},
                                          {0.95 * r, 0.75 * h},
                                          {0.72 * r, 0.89 * h}},
                                         4);
  outer.insert(outer.end(), belly.begin() + 1, belly.end());
  Profile lip(outer.back().x, outer.back().y);
  lip.curve(0.12 * r, 0.05 * h, -0.3, 3)
      .curve(0, 0.05 * h, 1, 5)
      .by(-0.14 * r, 0.01 * h)
      .to(0.64 * r, 0.9 * h);
  outer.insert(outer.end(), lip.points().begin() + 1, lip.points().end());
  outer.emplace_back(0.7 * r, 0.82 * h);
  Pot pot{{}, 0.9 * h};
  pot.model.add("pot", lathe(outer, 36));
  for (const double z : {0.5, 0.62}) {  // two raised bands
    Profile band(0.9 * r, z * h - 0.02 * h);
    band.to(0.975 * r, z * h - 0.015 * h).curve(0, 0.03 * h, 0.9, 4).to(0.9 * r, z * h + 0.02 * h);
    pot.model.add("pot", lathe(band.points(), 36));
  }
  pot.model.add("earth", disc(0.66 * r, pot.soil, 24));
  return pot;
}

Pot tub(double size, double height) {
  const double s = size / 2, h = height;
  Pot pot{{}, 0.9 * h};
  Mesh mesh = box(Vec3(-s, -s, -0.02), Vec3(s, s, h - 0.04), kUpright);
  const std::vector<Vec3> ring = {Vec3(s, -s, 0), Vec3(-s, -s, 0), Vec3(-s, s, 0), Vec3(s, s, 0)};
  Profile foot(0.03, -0.02), rim(-0.01, h - 0.12);
  foot.to(0.03, 0.07).curve(-0.04, 0.04, -0.3, 3);
  rim.by(0.02, 0)
      .curve(0.03, 0.04, -0.3, 4)
      .by(0.015, 0)
      .by(0, 0.06)
      .by(-0.01, 0.015)
      .to(-0.09, h)
      .by(-0.01, -0.015)
      .to(-0.1, 0.86 * h);
  mesh.append(moulding(foot.points(), ring, true));
  mesh.append(moulding(rim.points(), ring, true));
  for (int k = 0; k < 4; ++k) {
    mesh.append(bevelled_box(Vec3(-s + 0.09, -s - 0.016, 0.15), Vec3(s - 0.09, -s + 0.02, h - 0.17), 0.014),
                rotate_z(90.0 * k));
  }
  pot.model.add("stone", mesh);
  pot.model.add("earth", box(Vec3(-s + 0.05, -s + 0.05, 0), Vec3(s - 0.05, s - 0.05, pot.soil), kTop));
  return pot;
}

}  // namespace capcon::scenes
