#include "generator/columns.h"
#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/masonry.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::court {

namespace {
constexpr double kBeamSpace = 0.56;

/// Rails from `from` to `to`; they end inside pedestals.
Model rails(double from, double to) {
  Model model;
  const Profile foot = foot_rail(), hand = hand_rail(kRail - 0.11);
  for (const Profile* p : {&foot, &hand}) {
    model.add("stone", moulding(p->points(), {Vec3(from, 0, 0), Vec3(to, 0, 0)}, false));
  }
  return model;
}

/// Joists across the walk with boards on top of them, from the arcade to the outer wall.
Model ceiling(double from, double to) {
  Model model;
  const double top = kGallery - 0.02, boards = top - 0.05, y0 = kWall / 2 - 0.05, y1 = kWalk + 0.05;
  const int count = static_cast<int>((to - from) / kBeamSpace + 0.01);
  for (int i = 0; i < count; ++i) {
    const double x = from + kBeamSpace * (i + 0.5);
    model.add("timber",
              bevelled_box(Vec3(x - 0.065, y0, boards - 0.2), Vec3(x + 0.065, y1, boards + 0.005), 0.008));
  }
  const int planks = static_cast<int>((y1 - y0) / 0.21);
  for (int j = 0; j < planks; ++j) {
    const double a = y0 + (y1 - y0) * j / planks, b = y0 + (y1 - y0) * (j + 1) / planks - 0.006;
    model.add("timber", box(Vec3(from, a, boards), Vec3(to, b, boards + 0.02), kBottom | kSouth | kNorth));
  }
  return model;
}
}  // namespace

void add_galleries(Assembly& scene) {
  Model post;
  post.add("stone", baluster(kRail - 0.2), translate(0, 0, 0.1));
  scene.define("baluster", std::move(post));
  scene.define("rails", rails(-kBay / 2, kBay / 2));
  scene.define("rails-half", rails(-kBay / 2, 0));
  scene.define("ceiling", ceiling(-kBay / 2, kBay / 2));
  scene.define("ceiling-corner", ceiling(0.0, kWalk));
  for (const Side side : kSides) {
    const Matrix frame = side_frame(side);
    for (int bay = 0; bay < bays(side); ++bay) {
      const double u = bay_centre(side, bay);
      scene.place("ceiling", frame * translate(u, 0, 0));
      const bool stairs = side == Side::north && bay == bays(side) - 1;  // arrive in this bay's eastern half
      scene.place(stairs ? "rails-half" : "rails", frame * translate(u, 0, kGallery));
      for (int i = 0; i < (stairs ? 5 : 10); ++i) {
        const double x = (i < 5 ? -kBay / 4 : kBay / 4) + 0.212 * (i % 5 - 2);
        scene.place("baluster", frame * translate(u + x, 0, kGallery));
      }
    }
  }
  for (const double y : {-kHalfY, kHalfY}) {
    scene.place("ceiling-corner",
                y < 0 ? translate(-kHalfX, y, 0) * rotate_z(180) : translate(-kHalfX - kWalk, y, 0));
  }
  // What the tiles lie on: the arcades' filling up to the gallery's floor.
  Model bed;
  const double z = kGallery - 0.012, a = kWall / 2 + 0.02;
  bed.add("stone",
          box(Vec3(-10.3, kHalfY - a, z - 0.03), Vec3(kEastFace + 0.05, kHalfY + kWalk + 0.05, z), kTop));
  bed.add("stone",
          box(Vec3(-10.3, -kHalfY - kWalk - 0.05, z - 0.03), Vec3(kEastFace + 0.05, -kHalfY + a, z), kTop));
  bed.add("stone", box(Vec3(-10.3, -kHalfY + a, z - 0.03), Vec3(-kHalfX + a, kHalfY - a, z), kTop));
  scene.add("gallery-bed", std::move(bed));
}

}  // namespace capcon::scenes::court
