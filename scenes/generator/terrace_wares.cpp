#include <cmath>

#include "generator/foliage.h"
#include "generator/pots.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/terrace.h"
#include "generator/wares.h"

namespace capcon::scenes::belvedere {

namespace {
constexpr double kCrease = 40;
}

void add_wares(Assembly& scene) {
  Model vase;  // on two steps
  vase.add("stone", drum(0.72, 0.16, 96));
  vase.add("stone", drum(0.52, 0.34, 96));
  vase.add("lacquer", swirled_vase(1.2, 8, 112, 64), translate(0, 0, 0.338));
  scene.add("vase", vase, translate(0.05, 0.45, 0), kCrease);

  Model ring;
  ring.add("stone", drum(0.34, 0.5, 96));
  ring.add("gold", lobed_ring(0.36, 0.115, 192, 40), translate(0, 0, 0.5 - 0.012));
  scene.add("ring", ring, translate(-1.35, 0.05, 0) * rotate_z(-22), kCrease);

  Model globe;
  globe.add("stone", drum(0.36, 0.24, 96));
  globe.add("copper", spiral_ball(0.42, 112, 64), translate(0, 0, 0.24 + 0.385));
  scene.add("globe", globe, translate(1.4, -0.05, 0), kCrease);

  Model bowl;
  bowl.add("cobalt", gadrooned_bowl(0.34, 0.21, 12, 96));
  scene.add("bowl", bowl, translate(-0.72, -1.2, 0), kCrease);
  Model fruit;
  fruit.add("lemon", lemon(0.2, 40, 28));
  scene.define("lemon", fruit, kCrease);
  const Matrix dish = translate(-0.72, -1.2, 0);
  scene.place("lemon", dish * translate(-0.1, 0.05, 0.135) * rotate_z(30) * rotate_x(40));
  scene.place("lemon", dish * translate(0.1, 0.08, 0.135) * rotate_z(110) * rotate_x(10));
  scene.place("lemon", dish * translate(0.04, -0.11, 0.135) * rotate_z(-25) * rotate_x(80));
  scene.place("lemon", dish * translate(0.01, 0.02, 0.235) * rotate_z(60) * rotate_y(15));
  scene.place("lemon", translate(-0.28, -1.48, 0.07) * rotate_z(-40));

  Model shell;
  shell.add("porcelain", nautilus(0.62, 200, 32));
  scene.add("shell", shell, translate(0.78, -1.2, -0.004) * rotate_z(24), kCrease);
}

void add_plants(Assembly& scene) {
  const Pot pot = urn(0.6);
  Model model = pot.model;
  model.add(agave(0.75, 30, 402), translate(0, 0, pot.soil));
  scene.define("agave", model, kCrease);
  scene.place("agave", translate(-2.35, 1.35, 0) * rotate_z(40));
  scene.place("agave", translate(2.5, 1.3, 0) * rotate_z(170) * scale(0.9, 0.9, 0.9));
}

}  // namespace capcon::scenes::belvedere
