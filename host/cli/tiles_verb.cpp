#include "cli/tiles_verb.h"

#include <filesystem>

#include "cli/verbs.h"

namespace capcon::cli {

void add_tiles_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("tiles",
                                      "corner tile sets of capacity-constrained points\n\n"
                                      "  capcon tiles verify shipped\n"
                                      "  capcon tiles show shipped --width 4 -o tiling.svg\n"
                                      "  capcon tiles sheet c2n64 -o sheet.png\n"
                                      "  capcon tiles points c2n16-bounded --width 8 -o points.txt\n"
                                      "  capcon tiles make -o my.tiles\n"
                                      "  capcon tiles parts -o c2n16.parts\n");
  verb->require_subcommand(1);
  add_tiles_make(*verb);
  add_tiles_verify(*verb);
  add_tiles_show(*verb);
  add_tiles_sheet(*verb);
  add_tiles_points(*verb);
  add_tiles_parts(*verb);
}

TileSet named_tile_set(const std::string& name) {
  if (name == "shipped") return shipped_tile_set();
  // A word that is no file's name as tile sets have it: one of the shipped sets.
  const bool is_word = name.find_first_of("./") == std::string::npos && !std::filesystem::exists(name);
  return is_word ? shipped_tile_set(name) : read_tile_set(name);
}

const char* tile_set_help() {
  return "a tile set's file, or a shipped set: c2n16, c2n64, c3n16-compact, c2n16-bounded";
}

}  // namespace capcon::cli
