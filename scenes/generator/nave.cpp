#include "generator/nave.h"

namespace capcon::scenes {

Assembly nave() {
  Assembly scene("nave");
  church::add_piers(scene);
  church::add_arcade_walls(scene);
  church::add_outer_walls(scene);
  church::add_vaults(scene);
  church::add_apse(scene);
  church::add_floor(scene);
  church::add_furniture(scene);
  return scene;
}

}  // namespace capcon::scenes
