#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "cli/tiles_verb.h"
#include "tiling/make_tiles.h"
#include "tiling/tile_quality.h"

namespace capcon::cli {
namespace {

struct Options {
  MakeTilesOptions make;
  std::string output, method = "ccvt";
  bool compact = false, boundary = false, json = false, quiet = false;
};

void run(const Options& options) {
  if (options.json && options.output.empty())
    throw InputError("--json prints what was made, not the tiles: say where they go with -o FILE");
  if (options.compact && options.boundary)
    throw InputError("--compact and --boundary do not go together: choose one");
  if (!options.output.empty()) check_writable(options.output);
  const auto start = std::chrono::steady_clock::now();
  TileSet set;
  {
    Progress progress("tiles", 1, options.quiet);
    MakeTilesOptions make = options.make;
    if (options.compact) make.colouring = Colouring::apart;
    if (options.boundary) make.colouring = Colouring::bounded;
    if (options.method == "fpo") make.method = TileMethod::fpo;
    make.on_round = [&](double done, double energy) {
      progress.update(done, fmt::format("energy {:.4f}", energy));
    };
    set = make_tiles(make);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.output.empty()) {
    fmt::print("{}", format_tile_set(set));
    return;
  }
  write_tile_set(options.output, set);
  const TilingFigures figures = tiling_figures(set, 8, 0, set.points_per_tile, 4, 1);
  if (options.json) {
    const nlohmann::ordered_json result = {{"output", options.output},
                                           {"recipe", set.recipe},
                                           {"checksum", fmt::format("{:016x}", checksum(set))},
                                           {"seconds", seconds},
                                           {"figures", to_json(figures)}};
    fmt::print("{}\n", result.dump(2));
  } else if (!options.quiet) {
    fmt::print(stderr, "{}: {} tiles of {} points in {:.1f} s, energy {:.4f}, mean distance {:.3f}\n",
               options.output, set.tile_count(), set.points_per_tile, seconds, figures.energy,
               figures.delta_mean);
  }
}

}  // namespace

void add_tiles_make(CLI::App& tiles) {
  CLI::App* verb =
      tiles.add_subcommand("make",
                           "optimise and rank a tile set\n\n"
                           "Without options it makes the shipped set again, to the bit. The points of all "
                           "tiles move together until the\n"
                           "equal cells that they have in many random tilings are as compact as can be.\n");
  auto options = std::make_shared<Options>();
  MakeTilesOptions& make = options->make;
  verb->add_option("--colours", make.colours, "corner colours C: a complete set has C^4 tiles")
      ->capture_default_str();
  verb->add_option("--points", make.points_per_tile, "points of a tile")->capture_default_str();
  verb->add_option("--method", options->method, "ccvt: compact cells of equal area; fpo: farthest points")
      ->capture_default_str()
      ->check(CLI::IsMember({"ccvt", "fpo"}));
  verb->add_flag("--compact", options->compact,
                 "fewer tiles: corner colours but the first never beside themselves (C = 3: 35 tiles of 81)");
  verb->add_flag(
      "--boundary", options->boundary,
      "tiles that fill a square whose sides do not meet: C^4 inner, 4 C^2 side and 4 C corner tiles "
      "(C = 2: 40)");
  verb->add_option("--seed", make.seed, "another seed, another set")->capture_default_str();
  verb->add_option("--shared-corner", make.shared_corner,
                   "points of each quadrant shared by all tiles at a corner")
      ->capture_default_str();
  verb->add_option("--shared-edge", make.shared_edge, "points of each side shared by all tiles at an edge")
      ->capture_default_str();
  verb->add_option("--starts", make.starts, "random starts, the best is finished")->capture_default_str();
  verb->add_option("--rounds", make.rounds, "rounds of the finish, a start gets half")->capture_default_str();
  verb->add_option("--tilings", make.tilings,
                   "random 8 x 8 tilings to optimise on (default: 24, more for sets of more than 16 tiles)");
  verb->add_option("--moves", make.moves, "moves of the ranking, per point of the set")
      ->capture_default_str();
  verb->add_option("--flatness", make.flatness,
                   "how much an even mean tile counts against compact cells or distance; 0 gives a lattice "
                   "(default: 0.002, fpo 0.0002, with a boundary 0.0012)")
      ->check(CLI::Range(0.0, 1000.0));
  verb->add_option("-o,--output", options->output, "the tile set's file (default: standard output)")
      ->type_name("FILE");
  verb->add_flag("--json", options->json, "print one JSON object: checksum, figures, seconds");
  verb->add_flag("-q,--quiet", options->quiet, "no progress and no summary");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
