#include "generator/courtyard.h"

#include "generator/courtyard_plan.h"

namespace capcon::scenes {

Assembly courtyard(int scale) {
  Assembly scene("courtyard");
  court::add_paving(scene);
  court::add_arcades(scene);
  court::add_galleries(scene);
  court::add_roofs(scene);
  court::add_outer_walls(scene);
  court::add_stairs(scene);
  court::add_fountain(scene);
  court::add_furniture(scene);
  court::add_plants(scene);
  scene.repeat(scale, scale, Vec2(19, 19));
  return scene;
}

}  // namespace capcon::scenes
