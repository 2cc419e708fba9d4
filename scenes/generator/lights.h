#pragma once

#include <filesystem>

#include "image/image.h"

namespace capcon::scenes {

/// A painted tile for floors: a quarter flower in each corner, a star in the middle, lines along the edges,
/// so that it repeats. Linear values, `size` x `size`.
Image painted_tile(int size);

/// What scenes/lights.pbrt names: tile.png.
void write_lights_data(const std::filesystem::path& folder);

}  // namespace capcon::scenes
