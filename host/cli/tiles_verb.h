#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tiling/tile_set.h"

namespace capcon::cli {

void add_tiles_make(CLI::App& tiles);
void add_tiles_verify(CLI::App& tiles);
void add_tiles_show(CLI::App& tiles);

/// The tile set of a file, or the shipped one for the name "shipped".
TileSet named_tile_set(const std::string& name);

}  // namespace capcon::cli
