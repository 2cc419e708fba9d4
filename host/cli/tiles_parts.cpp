#include <fmt/format.h>

#include <memory>

#include "base/file.h"
#include "cli/tiles_verb.h"
#include "sampling/parts_store.h"

namespace capcon::cli {

void add_tiles_parts(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand(
      "parts",
      "make the shipped parts of the usual splits again, to the bit\n\n"
      "  capcon tiles parts -o c2n16.parts\n\n"
      "The parts of 16, 32, 64, 128 and 256 points of the shipped tile set c2n16, which "
      "the sampler capcon reads\n"
      "from the file beside it; without the file, or for another tile set, it makes them "
      "at every start.\n");
  auto output = std::make_shared<std::string>();
  verb->add_option("-o,--output", *output, "the file of parts")->required()->type_name("FILE");
  verb->callback([output] {
    check_writable(*output);
    write_file(*output, make_shipped_parts(shipped_tile_set()));
  });
}

}  // namespace capcon::cli
