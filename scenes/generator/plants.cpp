#include <glm/geometric.hpp>

#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/foliage.h"
#include "generator/pots.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::court {

namespace {
constexpr double kPergolaX0 = -6.0, kPergolaX1 = -3.3, kPergolaY0 = 0.6, kPergolaY1 = 4.6, kPergolaTop = 2.7;

/// Stone pillars, two long beams, cross beams and laths.
Model pergola() {
  Model model;
  for (const double x : {kPergolaX0, kPergolaX1}) {
    for (const double y : {kPergolaY0, 0.5 * (kPergolaY0 + kPergolaY1), kPergolaY1}) {
      model.add("stone", bevelled_box(Vec3(x - 0.15, y - 0.15, -0.05),
                                      Vec3(x + 0.15, y + 0.15, kPergolaTop - 0.18), 0.012));
      model.add("stone",
                bevelled_box(Vec3(x - 0.19, y - 0.19, -0.06), Vec3(x + 0.19, y + 0.19, 0.18), 0.015));
      model.add("stone", bevelled_box(Vec3(x - 0.18, y - 0.18, kPergolaTop - 0.27),
                                      Vec3(x + 0.18, y + 0.18, kPergolaTop - 0.17), 0.015));
    }
    model.add("timber", bevelled_box(Vec3(x - 0.07, kPergolaY0 - 0.35, kPergolaTop - 0.175),
                                     Vec3(x + 0.07, kPergolaY1 + 0.35, kPergolaTop), 0.01));
  }
  for (int i = 0; i <= 9; ++i) {
    const double y = kPergolaY0 - 0.2 + (kPergolaY1 - kPergolaY0 + 0.4) * i / 9;
    model.add("timber", bevelled_box(Vec3(kPergolaX0 - 0.35, y - 0.04, kPergolaTop - 0.03),
                                     Vec3(kPergolaX1 + 0.35, y + 0.04, kPergolaTop + 0.09), 0.008));
  }
  for (int i = 0; i <= 8; ++i) {
    const double x = kPergolaX0 - 0.2 + (kPergolaX1 - kPergolaX0 + 0.4) * i / 8;
    model.add("timber", bevelled_box(Vec3(x - 0.018, kPergolaY0 - 0.3, kPergolaTop + 0.085),
                                     Vec3(x + 0.018, kPergolaY1 + 0.3, kPergolaTop + 0.12), 0.004));
  }
  return model;
}

Model potted(const Pot& pot, const Model& plant, double size = 1) {
  Model model = pot.model;
  model.add(plant, translate(0, 0, pot.soil) * scale(size, size, size));
  return model;
}
}  // namespace

void add_plants(Assembly& scene) {
  scene.define("orange-tree", potted(tub(0.8, 0.55), orange_tree(2.9, 3000, 101)));
  scene.define("cypress", potted(urn(0.75), cypress(2.9, 2600, 102)));
  scene.define("shrub", potted(urn(0.62), shrub(0.36, 900, 103)));
  scene.define("geranium", potted(flower_pot(0.34), geranium(104)));
  scene.define("agave", potted(flower_pot(0.45), agave(0.6, 34, 105)));
  scene.define("climber", climber(2.4, 4.2, 2400, 106));
  scene.define("canopy", canopy(1.0, 420, 107));
  scene.add("pergola", pergola());

  const Dice dice(120);
  int number = 0;
  const auto stand = [&](const char* name, double x, double y, double z = 0) {
    const double size = dice.between(0.92, 1.08, number, 1);
    scene.place(name, translate(x, y, z) * rotate_z(dice.between(0, 360, number)) * scale(size, size, size));
    ++number;
  };
  const auto squarely = [&](const char* name, double x, double y, double turn) {
    scene.place(name, translate(x, y, 0) * rotate_z(turn));
  };
  squarely("orange-tree", 3.1, 3.2, 0);
  squarely("orange-tree", 3.1, -3.2, 90);
  squarely("orange-tree", -3.4, -3.3, 180);
  stand("cypress", 6.3, -4.75);
  for (const double y : {-4.6, -1.9, 0.9}) stand("shrub", -6.15, y - 0.2);
  for (const double x : {-4.2, -1.4, 1.4}) stand("agave", x + 0.75, kHalfY - 0.72);
  for (const double y : {-2.35, -1.45, 0.85}) stand("geranium", 5.12, y);
  for (const double x : {1.4, 4.2}) stand("shrub", x, -kHalfY + 0.78);
  for (int i = 0; i < 6; ++i) stand("geranium", 1.35 + 0.55 * i, kHalfY + kWalk - 0.35, kFloor);
  for (const double u : {-5.6, -2.8, 0.0, 2.8}) stand("geranium", u + 0.9, kHalfY + 0.62, kFloor);
  for (const double y : {3.6, 1.1, -1.2}) stand("agave", -kHalfX - kWalk + 0.55, y, kFloor);
  stand("geranium", 5.6, -4.55);
  stand("geranium", 5.95, -4.95);

  // Climbers on the east wall above and before the stairs, on a western pier, and over the pergola.
  const Matrix east = translate(kEastFace, 0, 0) * rotate_z(-90);
  scene.place("climber", east * translate(4.6, 0, 0));
  scene.place("climber", east * translate(5.15, 0, 0) * scale(-0.7, 1, 1.5));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      if ((i * 4 + j) % 5 == 3) continue;  // gaps let the light through
      scene.place("canopy", translate(kPergolaX0 - 0.15 + i, kPergolaY0 + 0.05 + j, kPergolaTop + 0.1) *
                                translate(0.5, 0.5, 0) * rotate_z(90.0 * ((i + 2 * j) % 4)) *
                                translate(-0.5, -0.5, 0));
    }
  }
}

}  // namespace capcon::scenes::court
