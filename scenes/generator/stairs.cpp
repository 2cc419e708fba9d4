#include "generator/columns.h"
#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/masonry.h"
#include "generator/solids.h"
#include "generator/wall.h"

namespace capcon::scenes::court {

namespace {
// The flight climbs to the north along the east wall and arrives at the north gallery.
constexpr int kRisers = 26;
constexpr double kRise = kGallery / kRisers, kTread = 0.29;
constexpr double kArrival = 3.2;                              // y of the last riser
constexpr double kFirst = kArrival - (kRisers - 1) * kTread;  // y of the first
constexpr double kString = 5.45, kStringThick = 0.3;          // x of the string's outer face
constexpr double kPitch = kRise / kTread;

/// Height of the string's top over the ground.
double string_top(double y) {
  return kRise + (y - kFirst) * kPitch + 0.1;
}

Model flight() {
  Model model;
  const double x0 = kString + kStringThick - 0.02, x1 = kEastFace + 0.02;
  for (int i = 0; i < kRisers - 1; ++i) {
    const double y = kFirst + i * kTread, z = (i + 1) * kRise;
    model.add("stone", bevelled_box(Vec3(x0, y - 0.025, z - 0.045), Vec3(x1, y + kTread + 0.02, z), 0.008));
    model.add("stone", box(Vec3(x0, y, i * kRise - 0.005), Vec3(x1, y + 0.1, z - 0.04), kSouth));
  }
  model.add("stone",
            box(Vec3(x0, kArrival, kGallery - kRise), Vec3(x1, kArrival + 0.1, kGallery - 0.04), kSouth));
  return model;
}

/// The string wall with its niches; in its own frame x = -y of the court, the front faces west.
Model string_wall() {
  Model model;
  const Opening low{.centre = -0.1, .half_width = 0.5, .sill = -1, .springing = 0.95, .segments = 26};
  const Opening high{.centre = -2.0, .half_width = 0.7, .sill = -1, .springing = 1.75, .segments = 26};
  const Opening passage{.centre = -4.27, .half_width = 0.85, .sill = -1, .springing = 2.55, .segments = 26};
  WallPlan raked{.from = -kArrival,
                 .to = -kFirst,
                 .foot = -0.05,
                 .head = string_top(kArrival),
                 .thickness = kStringThick,
                 .slope = -kPitch,
                 .openings = {high, low}};
  WallPlan landing{.from = -kHalfY + kWall / 2 - 0.01,
                   .to = -kArrival,
                   .foot = -0.05,
                   .head = string_top(kArrival),
                   .thickness = kStringThick,
                   .openings = {passage}};
  model.add("plaster", wall(raked));
  model.add("plaster", wall(landing));
  WallPlan lining = raked;  // the niches reach the east wall
  lining.thickness = kEastFace - kString - kStringThick;
  lining.front = lining.back = lining.top = false;
  model.add("plaster", wall(lining), translate(0, kStringThick, 0));
  for (const Opening& o : {low, high, passage}) {
    const int stones = o.half_width < 0.6 ? 11 : 13;
    model.add("stone", voussoirs(o.half_width, 0.2, 0.03, stones, o.springing), translate(o.centre, 0, 0));
  }
  // A coping under the balusters.
  Profile coping(-0.04, -0.06);
  coping.by(kStringThick + 0.08, 0)
      .by(0, 0.05)
      .by(-0.02, 0.015)
      .by(-kStringThick - 0.04, 0)
      .by(-0.02, -0.015)
      .by(0, -0.05);
  const double end = kHalfY - kWall / 2, top = string_top(kArrival);
  Model placed;
  placed.add(model, translate(kString, 0, 0) * rotate_z(-90));
  const double x = kString + kStringThick;
  placed.add(
      "stone",
      moulding(coping.points(),
               {Vec3(x, kFirst, string_top(kFirst)), Vec3(x, kArrival, top), Vec3(x, end, top)}, false));
  return placed;
}

Model landing() {
  Model model;
  const double x0 = kString + kStringThick - 0.02, x1 = kEastFace + 0.02, y1 = kHalfY + 0.385;
  for (int i = 0; i < 3; ++i) {
    const double a = kArrival - 0.02 + (y1 - kArrival + 0.02) * i / 3,
                 b = kArrival - 0.02 + (y1 - kArrival + 0.02) * (i + 1) / 3;
    model.add("stone",
              bevelled_box(Vec3(x0, a + 0.003, kGallery - 0.06), Vec3(x1, b - 0.003, kGallery), 0.006));
  }
  const double arcade = kHalfY - kWall / 2 + 0.01;
  model.add("plaster", box(Vec3(x0, kArrival + 0.3, 4.2), Vec3(x1, arcade, 4.5), kBottom));
  model.add("plaster", box(Vec3(x0, kArrival, -0.05), Vec3(x1, kArrival + 0.3, 4.3), kNorth));
  return model;
}
}  // namespace

void add_stairs(Assembly& scene) {
  scene.add("stairs", flight());
  scene.add("stairs-string", string_wall());
  scene.add("stairs-landing", landing());

  const double x = kString + kStringThick / 2, height = kRail - 0.2, top = string_top(kArrival);
  Model raked, post, rail;
  raked.add("stone", baluster(height));
  raked.add("stone", box(Vec3(-0.065, -0.065, -0.05), Vec3(0.065, 0.065, -0.005), kUpright));
  raked.add("stone", box(Vec3(-0.062, -0.062, height + 0.005), Vec3(0.062, 0.062, height + 0.05), kUpright));
  scene.define("baluster-raked", std::move(raked));
  for (int i = 0; i < 30; ++i) {
    const double y = kFirst + 0.13 + 0.2417 * i;
    if (y < kArrival - 0.2) scene.place("baluster-raked", translate(x, y, string_top(y) + 0.045));
  }
  for (int i = 0; i < 7; ++i) scene.place("baluster", translate(x, kArrival + 0.45 + 0.25 * i, top - 0.1));
  const double end = kHalfY - 0.1, low = kFirst - 0.1, lift = height + 0.05;
  rail.add("stone", moulding(hand_rail(0).points(),
                             {Vec3(x, low, string_top(low) + lift),
                              Vec3(x, kArrival + 0.12, string_top(kArrival + 0.12) + lift)},
                             false));
  rail.add("stone",
           moulding(hand_rail(0).points(),
                    {Vec3(x, kArrival + 0.2, top + lift - 0.07), Vec3(x, end, top + lift - 0.07)}, false));
  scene.add("stairs-rail", std::move(rail));
  post.add("stone", newel(1.42, 0.17));
  scene.define("newel", std::move(post));
  scene.place("newel", translate(x, kFirst - 0.16, 0));
  scene.place("newel", translate(x, kArrival + 0.17, top - 0.3));
}

}  // namespace capcon::scenes::court
