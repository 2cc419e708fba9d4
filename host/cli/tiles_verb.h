#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tiling/tile_set.h"

namespace capcon::cli {

void add_tiles_make(CLI::App& tiles);
void add_tiles_verify(CLI::App& tiles);
void add_tiles_show(CLI::App& tiles);
void add_tiles_sheet(CLI::App& tiles);
void add_tiles_parts(CLI::App& tiles);
void add_tiles_points(CLI::App& tiles);

/// The tile set of a file, or a shipped one for its name: "shipped" (the same as "c2n16"), "c2n64",
/// "c3n16-compact", "c2n16-bounded".
TileSet named_tile_set(const std::string& name);
/// What help says of such a name.
const char* tile_set_help();

}  // namespace capcon::cli
