#pragma once

#include "generator/assembly.h"

namespace capcon::scenes {

/// Sculptures on a paper backdrop, for soft shadows of many shapes: scenes/direct.pbrt.
Assembly atelier();

namespace studio {
// Each adds one trade's work to the scene.
void add_backdrop(Assembly& scene);
void add_arches(Assembly& scene);
void add_stairs(Assembly& scene);
void add_screen(Assembly& scene);
void add_mobile(Assembly& scene);
void add_sculptures(Assembly& scene);
void add_branch(Assembly& scene);
}  // namespace studio

}  // namespace capcon::scenes
