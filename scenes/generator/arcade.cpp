#include <cmath>

#include "generator/columns.h"
#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/masonry.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/wall.h"

namespace capcon::scenes::court {

namespace {
constexpr double kArchHead = 4.36;  // top of the lower arcade's wall
constexpr double kUpperHead = 7.8;
constexpr double kUpperWall = 0.34;

Model lower_bay() {
  Model model;
  WallPlan plan{
      .from = -kBay / 2, .to = kBay / 2, .foot = kSpringing - 0.005, .head = kArchHead, .thickness = kWall};
  plan.openings = {{.half_width = kArchHalf, .sill = -1, .springing = kSpringing, .segments = 34}};
  model.add("plaster", wall(plan), translate(0, -kWall / 2, 0));
  const Mesh stones = voussoirs(kArchHalf, 0.24, 0.035, 17, kSpringing);
  model.add("stone", stones, translate(0, -kWall / 2, 0));
  model.add("stone", stones, rotate_z(180) * translate(0, -kWall / 2, 0));
  return model;
}

/// A round boss for the spandrel over a column.
Mesh medallion() {
  Profile p(0.22, -0.01);
  p.by(0, 0.02).curve(-0.03, 0, 1, 5).by(-0.02, -0.012).by(-0.02, 0).curve(-0.15, 0.035, 0.25, 5);
  return lathe(p.points(), 28);
}

Model upper_bay() {
  Model model;
  WallPlan plan{.from = -kBay / 2,
                .to = kBay / 2,
                .foot = kUpperSpringing - 0.005,
                .head = kUpperHead,
                .thickness = kUpperWall};
  const std::vector<Vec2> band_section = Profile(0.19, -0.01)
                                             .to(0.19, 0.02)
                                             .by(-0.02, 0.025)
                                             .by(-0.05, 0)
                                             .by(-0.01, -0.012)
                                             .by(-0.07, 0)
                                             .by(-0.005, -0.03)
                                             .points();
  for (const double x : {-kBay / 4, kBay / 4}) {
    const Opening o{
        .centre = x, .half_width = kUpperArchHalf, .sill = 0, .springing = kUpperSpringing, .segments = 24};
    plan.openings.push_back(o);
    const Mesh band = archivolt(o, band_section, false);
    model.add("stone", band, translate(0, -kUpperWall / 2, 0));
    model.add("stone", band, rotate_z(180) * translate(0, -kUpperWall / 2, 0));
  }
  model.add("plaster", wall(plan), translate(0, -kUpperWall / 2, 0));
  return model;
}

/// A moulding along the court's three arcades, from the east wall to the east wall.
Mesh court_moulding(const Profile& profile, double half_wall) {
  const double x = kHalfX - half_wall, y = kHalfY - half_wall, end = kEastFace + 0.02;
  return moulding(profile.points(), {Vec3(end, y, 0), Vec3(-x, y, 0), Vec3(-x, -y, 0), Vec3(end, -y, 0)},
                  false);
}

Mesh string_course() {
  Profile p(-0.01, kArchHead - 0.04);
  p.by(0.03, 0)
      .curve(0, 0.05, 1, 5)
      .by(0, 0.02)
      .by(0.02, 0)
      .curve(0.06, 0.08, -0.4, 5)
      .by(0.02, 0)
      .by(0, 0.09);
  p.curve(-0.03, 0.03, 0.4, 3).to(-0.3, kGallery - 0.01);
  return court_moulding(p, kWall / 2);
}

Mesh cornice() {
  Profile p(-0.01, kUpperHead - 0.3);
  p.by(0.02, 0)
      .by(0, 0.05)
      .curve(0.05, 0.06, 0.4, 5)
      .by(0.02, 0)
      .by(0, 0.03)
      .curve(0.06, 0.07, -0.4, 5)
      .by(0.02, 0)
      .by(0, 0.06);
  p.to(-0.05, kUpperHead + 0.005);
  return court_moulding(p, kUpperWall / 2);
}
}  // namespace

void add_arcades(Assembly& scene) {
  scene.define("bay-lower", lower_bay());
  scene.define("bay-upper", upper_bay());
  Model column, slender, pier, pedestal, boss;
  boss.add("stone", medallion(), translate(0, -kWall / 2, 3.98) * rotate_x(90));
  scene.define("medallion", std::move(boss));
  column.add("stone", fluted_column(kSpringing - kFloor, 0.2));
  slender.add("stone", slender_column(kUpperSpringing - kGallery - kRail, 0.095));
  pier.add("stone", square_pier(kSpringing - kFloor, 0.27));
  pier.add("stone", box(Vec3(-0.262, -0.262, kSpringing - kFloor - 0.02),
                        Vec3(0.262, 0.262, kGallery - kFloor), kUpright));
  pedestal.add("stone", bevelled_box(Vec3(-0.17, -0.17, -0.02), Vec3(0.17, 0.17, kRail + 0.008), 0.008));
  scene.define("column-lower", std::move(column));
  scene.define("column-upper", std::move(slender));
  scene.define("pier", std::move(pier));
  scene.define("pedestal", std::move(pedestal));

  for (const Side side : kSides) {
    const Matrix frame = side_frame(side);
    for (int bay = 0; bay < bays(side); ++bay) {
      const double u = bay_centre(side, bay);
      scene.place("bay-lower", frame * translate(u, 0, 0));
      scene.place("bay-upper", frame * translate(u, 0, 0));
      if (bay > 0) {
        scene.place("column-lower", frame * translate(u - kBay / 2, 0, kFloor));
        scene.place("medallion", frame * translate(u - kBay / 2, 0, 0));
      }
      for (const double x : {u - kBay / 2, u}) {
        if (x == -half_length(side)) continue;  // the corners have piers
        scene.place("column-upper", frame * translate(x, 0, kGallery + kRail));
        scene.place("pedestal", frame * translate(x, 0, kGallery));
      }
    }
  }
  Model upper_pier;
  const double upper = kUpperSpringing - kGallery;
  upper_pier.add("stone", square_pier(upper, 0.2));
  upper_pier.add(
      "stone", box(Vec3(-0.195, -0.195, upper - 0.02), Vec3(0.195, 0.195, kUpperHead - kGallery), kUpright));
  scene.define("pier-upper", std::move(upper_pier));
  for (const double x : {-kHalfX, kHalfX}) {
    for (const double y : {-kHalfY, kHalfY}) {
      scene.place("pier", translate(x, y, kFloor));
      scene.place("pier-upper", translate(x, y, kGallery));
    }
  }
  Model mouldings;
  mouldings.add("stone", string_course());
  mouldings.add("stone", cornice());
  scene.add("mouldings", std::move(mouldings));
}

}  // namespace capcon::scenes::court
