#include "generator/nave.h"
#include "generator/nave_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/tracery.h"
#include "generator/vault.h"
#include "generator/wall.h"

namespace capcon::scenes::church {

namespace {
/// A slim column for the triforium, on z = 0.
Mesh colonnette(double height) {
  const double h = height;
  return lathe({{0.0, -0.01},
                {0.09, -0.01},
                {0.09, 0.05},
                {0.055, 0.1},
                {0.052, h - 0.19},
                {0.07, h - 0.18},
                {0.055, h - 0.16},
                {0.115, h - 0.045},
                {0.115, h + 0.005},
                {0.0, h + 0.005}},
               7);
}

Mesh string_course(double z) {
  Profile p(-0.01, z - 0.14);
  p.by(0.03, 0).curve(0.06, 0.06, -0.4, 3).by(0.02, 0).by(0, 0.05).to(-0.01, z + 0.01);
  return moulding(p.points(), {Vec3(kBay / 2, 0, 0), Vec3(-kBay / 2, 0, 0)}, false);
}

/// One bay of the arcade wall round its middle: arcade, triforium and clerestory.
Model arcade_bay() {
  Model model;
  const Opening arch{
      .half_width = kArcadeHalf, .sill = -1, .springing = kCapital, .arch = Arch::pointed, .segments = 24};
  model.add("wall", wall({.from = -kBay / 2,
                          .to = kBay / 2,
                          .foot = kCapital - 0.005,
                          .head = kArcadeHead,
                          .thickness = kThick,
                          .top = false,
                          .openings = {arch}}));
  const std::vector<Vec2> orders = Profile(0.46, -0.01)
                                       .by(0, 0.08)
                                       .curve(-0.14, 0.02, 0.3, 2)
                                       .by(0, -0.06)
                                       .by(-0.06, 0)
                                       .curve(-0.12, -0.01, 0.4, 2)
                                       .by(-0.13, -0.06)
                                       .points();
  model.add("stone", archivolt(arch, orders, false));
  model.add("stone",
            archivolt(arch, {{0.3, -0.01}, {0.3, 0.06}, {0.12, 0.06}, {0.1, 0.03}, {0.0, -0.02}}, false),
            translate(0, kThick, 0) * rotate_z(180));

  WallPlan triforium{.from = -kBay / 2,
                     .to = kBay / 2,
                     .foot = kArcadeHead,
                     .head = kTriforiumHead,
                     .thickness = 0.3,
                     .back = false,
                     .top = false};
  for (int k = 0; k < 4; ++k) {
    triforium.openings.push_back({.centre = 0.92 * (k - 1.5),
                                  .half_width = 0.36,
                                  .sill = 8.15,
                                  .springing = 9.05,
                                  .arch = Arch::pointed,
                                  .segments = 10});
    model.add("stone", archivolt(triforium.openings.back(),
                                 {{0.09, -0.01}, {0.09, 0.03}, {0.02, 0.04}, {-0.02, 0.0}}, false));
  }
  model.add("wall", wall(triforium));
  model.add("wall", box(Vec3(-kBay / 2, 0.29, 8.1), Vec3(kBay / 2, 0.3, 9.7), kSouth));
  for (int k = 0; k < 5; ++k) model.add("stone", colonnette(1.05), translate(0.92 * (k - 2), -0.02, 8.0));

  const Opening window{
      .half_width = 0.95, .sill = 10.5, .springing = 12.5, .arch = Arch::pointed, .segments = 16};
  model.add("wall", wall({.from = -kBay / 2,
                          .to = kBay / 2,
                          .foot = kTriforiumHead,
                          .head = kHead,
                          .thickness = 0.5,
                          .back = false,
                          .top = false,
                          .openings = {window}}));
  model.add("stone", hood(window));
  model.add(two_lights(window, 0.3));
  model.add("stone", bevelled_box(Vec3(-1.22, -0.1, 10.36), Vec3(1.22, 0.34, 10.51), 0.02));
  for (const double z : {kArcadeHead + 0.1, kTriforiumHead + 0.1}) model.add("stone", string_course(z));
  return model;
}

/// One bay of an aisle's outer wall round its middle, its face at y = 0.
Model aisle_bay() {
  Model model;
  const Opening window{
      .half_width = 0.7, .sill = 2.1, .springing = 4.5, .arch = Arch::pointed, .segments = 14};
  model.add("wall", wall({.from = -kBay / 2,
                          .to = kBay / 2,
                          .foot = -0.05,
                          .head = kAisleHead,
                          .thickness = 0.5,
                          .back = false,
                          .top = false,
                          .openings = {window}}));
  model.add("stone", hood(window));
  model.add(lancet(window, 0.3));
  model.add("stone", string_course(1.75));
  model.add("stone",
            bevelled_box(Vec3(-kBay / 2 + 0.42, -0.4, -0.05), Vec3(kBay / 2 - 0.42, 0.05, 0.45), 0.02));
  return model;
}

/// The west wall, its face towards +x at x = 0: a portal, lancets over it; and the ends of the aisles.
Model west_wall() {
  Model model;
  const Opening portal{
      .half_width = 1.3, .sill = -0.05, .springing = 2.6, .arch = Arch::pointed, .segments = 24};
  const Opening great{
      .half_width = 1.5, .sill = 7.4, .springing = 11.2, .arch = Arch::pointed, .segments = 24};
  model.add("wall", wall({.from = -kAisle - 0.1,
                          .to = kAisle + 0.1,
                          .foot = -0.05,
                          .head = 6.4,
                          .thickness = 0.6,
                          .back = false,
                          .top = false,
                          .openings = {portal}}));
  model.add("wall", wall({.from = -kAisle - 0.1,
                          .to = kAisle + 0.1,
                          .foot = 6.4,
                          .head = kHead,
                          .thickness = 0.6,
                          .back = false,
                          .top = false,
                          .openings = {great}}));
  for (const Opening& o : {portal, great}) model.add("stone", hood(o));
  model.add(two_lights(great, 0.3));
  model.add("timber", box(Vec3(-1.35, 0.3, -0.05), Vec3(-0.006, 0.34, 5.0), kSouth | kEast));
  model.add("timber", box(Vec3(0.006, 0.3, -0.05), Vec3(1.35, 0.34, 5.0), kSouth | kWest));
  Model placed;
  placed.add(model, rotate_z(90));
  return placed;
}

/// The aisles' east ends, facing west at x = kLength + 0.45.
Model aisle_end() {
  Model model;
  const double middle = 0.5 * (kFace + kThick + kAisle), half = 0.5 * (kAisle - kFace);
  const Opening window{
      .half_width = 0.7, .sill = 2.1, .springing = 4.5, .arch = Arch::pointed, .segments = 14};
  model.add("wall", wall({.from = -half,
                          .to = half + 0.1,
                          .foot = -0.05,
                          .head = kAisleHead,
                          .thickness = 0.5,
                          .back = false,
                          .top = false,
                          .openings = {window}}));
  model.add("stone", hood(window));
  model.add(lancet(window, 0.3));
  Model placed;
  placed.add(model, translate(kLength + 0.45, -middle, 0) * rotate_z(-90));
  return placed;
}
}  // namespace

void add_arcade_walls(Assembly& scene) {
  scene.define("arcade-bay", arcade_bay());
  for (const bool north : {true, false}) {
    for (int i = 0; i < kBays; ++i)
      scene.place("arcade-bay", wall_frame(north) * translate(bay_centre(i), 0, 0));
  }
}

void add_outer_walls(Assembly& scene) {
  scene.define("aisle-bay", aisle_bay());
  for (const bool north : {true, false}) {
    for (int i = 0; i < kBays; ++i)
      scene.place("aisle-bay", wall_frame(north) * translate(bay_centre(i), kAisle - kFace, 0));
  }
  scene.add("west-wall", west_wall());
  scene.define("aisle-end", aisle_end());
  scene.place("aisle-end");
  scene.place("aisle-end", scale(1, -1, 1));
}

}  // namespace capcon::scenes::church
