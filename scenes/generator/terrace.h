#pragma once

#include "generator/assembly.h"

namespace capcon::scenes {

/// A round terrace above the sea with polished, glazed and lacquered things: scenes/splitting.pbrt.
Assembly terrace();

/// What its scene file names besides: sky.exr and lacquer.brdf.
void write_terrace_data(const std::filesystem::path& folder);

namespace belvedere {
// Each adds one trade's work to the scene.
void add_floor(Assembly& scene);
void add_balustrade(Assembly& scene);
void add_columns(Assembly& scene);
void add_wares(Assembly& scene);
void add_plants(Assembly& scene);
}  // namespace belvedere

}  // namespace capcon::scenes
