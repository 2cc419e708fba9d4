#pragma once

#include "generator/assembly.h"

namespace capcon::scenes {

/// The courtyard: `scale` x `scale` courts side by side, each with its share of plants.
Assembly courtyard(int scale);

namespace court {
// Each adds one trade's work to the scene.
void add_paving(Assembly& scene);
void add_arcades(Assembly& scene);
void add_galleries(Assembly& scene);
void add_roofs(Assembly& scene);
void add_outer_walls(Assembly& scene);
void add_stairs(Assembly& scene);
void add_fountain(Assembly& scene);
void add_furniture(Assembly& scene);
void add_plants(Assembly& scene);
}  // namespace court

}  // namespace capcon::scenes
