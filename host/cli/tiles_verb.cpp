#include "cli/tiles_verb.h"

#include "cli/verbs.h"

namespace capcon::cli {

void add_tiles_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("tiles",
                                      "corner tile sets of capacity-constrained points\n\n"
                                      "  capcon tiles verify shipped\n"
                                      "  capcon tiles show shipped --width 4 -o tiling.svg\n"
                                      "  capcon tiles make -o my.tiles\n");
  verb->require_subcommand(1);
  add_tiles_make(*verb);
  add_tiles_verify(*verb);
  add_tiles_show(*verb);
}

TileSet named_tile_set(const std::string& name) {
  return name == "shipped" ? shipped_tile_set() : read_tile_set(name);
}

}  // namespace capcon::cli
