#include "generator/atelier.h"

namespace capcon::scenes {

Assembly atelier() {
  Assembly scene("direct");
  studio::add_backdrop(scene);
  studio::add_arches(scene);
  studio::add_stairs(scene);
  studio::add_screen(scene);
  studio::add_mobile(scene);
  studio::add_sculptures(scene);
  studio::add_branch(scene);
  return scene;
}

}  // namespace capcon::scenes
