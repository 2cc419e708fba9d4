#pragma once

#include "generator/assembly.h"

namespace capcon::scenes {

/// A vaulted nave with aisles and an apse, about 100,000 triangles, closed on all sides.
Assembly nave();

namespace church {
// Each adds one trade's work to the scene.
void add_piers(Assembly& scene);
void add_arcade_walls(Assembly& scene);
void add_outer_walls(Assembly& scene);
void add_vaults(Assembly& scene);
void add_apse(Assembly& scene);
void add_floor(Assembly& scene);
void add_furniture(Assembly& scene);
}  // namespace church

}  // namespace capcon::scenes
