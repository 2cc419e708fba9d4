#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/joinery.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/wall.h"

namespace capcon::scenes::court {

namespace {
constexpr double kThick = 0.4;

/// One bay of an outer wall, its face at y = 0, all storeys.
Model outer_bay(bool door_below) {
  Model model;
  const Opening ground_door{
      .half_width = 0.6, .sill = kFloor, .springing = 2.25, .arch = Arch::segmental, .segments = 12};
  const Opening ground_window{.half_width = 0.5, .sill = 1.15, .springing = 2.4, .arch = Arch::flat};
  const Opening upper_door{.half_width = 0.5, .sill = kGallery, .springing = 6.75, .arch = Arch::flat};
  const Opening upper_window{.half_width = 0.42, .sill = 5.5, .springing = 6.75, .arch = Arch::flat};
  const Opening attic{.half_width = 0.3, .sill = 9.75, .springing = 10.2, .arch = Arch::flat};
  const auto storey = [&](double foot, double head, const Opening& o) {
    model.add("plaster", wall({.from = -kBay / 2,
                               .to = kBay / 2,
                               .foot = foot,
                               .head = head,
                               .thickness = kThick,
                               .back = false,
                               .top = false,
                               .openings = {o}}));
  };
  storey(-0.05, kGallery - 0.3, door_below ? ground_door : ground_window);
  storey(kGallery - 0.3, 9.0, door_below ? upper_window : upper_door);
  storey(9.0, kOuterHead, attic);
  model.add(door_below ? door(ground_door) : window(ground_window, true));
  model.add(door_below ? window(upper_window, false) : door(upper_door));
  model.add(window(attic, false));
  return model;
}

Model plain_wall(double length, double foot = -0.05) {
  Model model;
  model.add("plaster", wall({.from = 0,
                             .to = length,
                             .foot = foot,
                             .head = kOuterHead,
                             .thickness = kThick,
                             .back = false,
                             .top = false}));
  return model;
}

/// The wall over the stairs, with a row of windows and a string course under them.
Model east_wall() {
  Model model;
  const double half = kHalfY + kWalk, sill_course = 5.8, attic_foot = 9.0;
  WallPlan low{.from = -half,
               .to = half,
               .foot = -0.05,
               .head = sill_course,
               .thickness = kThick,
               .back = false,
               .top = false};
  WallPlan middle = low, high = low;
  middle.foot = sill_course;
  middle.head = high.foot = attic_foot;
  high.head = kOuterHead;
  for (const double x : {-3.45, -1.15, 1.15, 3.45}) {
    const Opening main{.centre = x, .half_width = 0.45, .sill = 6.25, .springing = 7.6, .arch = Arch::flat};
    const Opening attic{.centre = x, .half_width = 0.3, .sill = 9.75, .springing = 10.2, .arch = Arch::flat};
    middle.openings.push_back(main);
    high.openings.push_back(attic);
    for (Opening o : {main, attic}) {
      o.centre = 0;  // a window is drawn round its own middle
      model.add(window(o, o.sill < 8), translate(x, 0, 0));
    }
  }
  for (const WallPlan& plan : {low, middle, high}) model.add("plaster", wall(plan));
  Profile course(-0.01, sill_course - 0.2);
  course.by(0.03, 0)
      .curve(0, 0.04, 1, 5)
      .by(0, 0.02)
      .curve(0.05, 0.06, -0.4, 5)
      .by(0.02, 0)
      .by(0, 0.06)
      .to(-0.01, sill_course + 0.03);
  model.add("stone", moulding(course.points(), {Vec3(kHalfY - 0.1, 0, 0), Vec3(-kHalfY + 0.1, 0, 0)}, false));
  return model;
}

/// Cornice and coping round all four outer walls, and their outsides.
Model crown() {
  const double x0 = -kHalfX - kWalk, x1 = kEastFace, y = kHalfY + kWalk;
  const std::vector<Vec3> loop = {Vec3(x0, -y, 0), Vec3(x1, -y, 0), Vec3(x1, y, 0), Vec3(x0, y, 0)};
  Profile p(-0.01, kOuterHead - 0.32);
  p.by(0.03, 0)
      .by(0, 0.06)
      .curve(0.06, 0.07, 0.4, 5)
      .by(0.02, 0)
      .by(0, 0.03)
      .curve(0.07, 0.08, -0.4, 5)
      .by(0.02, 0)
      .by(0, 0.09);
  p.to(-0.2, kOuterHead + 0.1).to(-kThick - 0.06, kOuterHead).by(0, -0.1).by(0.06, 0).to(-kThick, -0.2);
  Model model;
  model.add("stone", moulding(p.points(), loop, true));
  return model;
}
}  // namespace

void add_outer_walls(Assembly& scene) {
  scene.define("outer-door", outer_bay(true));
  scene.define("outer-window", outer_bay(false));
  scene.define("outer-corner", plain_wall(kWalk));
  for (const Side side : kSides) {
    const Matrix frame = side_frame(side) * translate(0, kWalk, 0);
    for (int bay = 0; bay < bays(side); ++bay) {
      scene.place(bay % 2 == 0 ? "outer-window" : "outer-door",
                  frame * translate(bay_centre(side, bay), 0, 0));
    }
    if (side != Side::south) scene.place("outer-corner", frame * translate(-half_length(side) - kWalk, 0, 0));
    if (side != Side::north) scene.place("outer-corner", frame * translate(half_length(side), 0, 0));
  }
  const Matrix east = translate(kEastFace, 0, 0) * rotate_z(-90);
  scene.add("east-wall", east_wall(), east);
  scene.add("crown", crown());
}

}  // namespace capcon::scenes::court
