#include "generator/chairs.h"
#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/profiles.h"

namespace capcon::scenes::court {

void add_furniture(Assembly& scene) {
  scene.define("table", round_table());
  scene.define("chair", ladder_chair());
  scene.define("ware", table_ware());
  scene.define("lantern", lantern());
  scene.define("bench", stone_bench());

  const Dice dice(130);
  int number = 0;
  const auto seats = [&](double x, double y, int chairs, double turn) {
    scene.place("table", translate(x, y, 0.003) * rotate_z(turn));
    scene.place("ware", translate(x, y, 0.743) * rotate_z(turn + 45));
    for (int k = 0; k < chairs; ++k, ++number) {
      const double a = turn + 360.0 * k / chairs + dice.between(-9, 9, number),
                   away = dice.between(0.6, 0.82, number, 1);
      scene.place("chair", translate(x, y, 0.003) * rotate_z(a) * translate(0, -away, 0) *
                               rotate_z(dice.between(-14, 14, number, 2)));
    }
  };
  seats(-4.65, 1.7, 4, 10);
  seats(-4.6, 3.6, 4, 40);
  seats(-1.3, 3.9, 3, 75);
  seats(0.6, -3.7, 3, 20);
  for (const Side side : kSides) {
    for (int bay = 0; bay < bays(side); ++bay) {
      scene.place("lantern", side_frame(side) * translate(bay_centre(side, bay), kWalk / 2, kGallery - 0.06));
      if (bay % 2 == 1 || side == Side::west) continue;
      scene.place("bench", side_frame(side) * translate(bay_centre(side, bay), kWalk, kFloor));
    }
  }
}

}  // namespace capcon::scenes::court
