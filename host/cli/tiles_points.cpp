#include <fmt/format.h>

#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "cli/tiles_verb.h"
#include "tiling/tiling.h"

namespace capcon::cli {
namespace {

constexpr std::uint64_t kMostPoints = 100'000'000;

struct Options {
  std::string file, output;
  std::uint32_t width = 8, ranks = 0, count = 1;
  std::uint64_t seed = 1;
  bool quiet = false;
};

void run(const Options& options) {
  const TileSet set = named_tile_set(options.file);
  if (options.ranks > set.points_per_tile)
    throw InputError(
        fmt::format("--ranks {}: a tile of this set has {} points", options.ranks, set.points_per_tile));
  if (set.bounded() && options.width < kLeastBoundedSide)
    throw InputError("--width 1: a square with a border takes 2 x 2 tiles or more");
  const std::uint32_t ranks = options.ranks == 0 ? set.points_per_tile : options.ranks;
  if (std::uint64_t(options.width) * options.width * ranks * options.count > kMostPoints)
    throw InputError(fmt::format("more than {} points: take a smaller --width or --count", kMostPoints));
  if (!options.output.empty()) check_writable(options.output);
  const GaussianTiling tiling(options.width, 0);
  std::vector<Points> sets;
  for (std::uint32_t i = 0; i < options.count; ++i)
    sets.push_back(tile_points(set, tiling, random_colours(tiling, set, options.seed + i), ranks));
  if (options.output.empty()) {
    fmt::print("{}", format_points(sets));
    return;
  }
  write_points(options.output, sets);
  if (!options.quiet)
    fmt::print(stderr, "{}: {} x {} points of {} x {} tiles, {}\n", options.output, options.count,
               sets.front().size(), options.width, options.width,
               set.bounded() ? "in the square" : "on the torus");
}

}  // namespace

void add_tiles_points(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand(
      "points",
      "the points of random tilings, K x K tiles scaled to the unit square\n\n"
      "  capcon tiles points c2n16-bounded --width 8 -o points.txt    1024 points of a square with a border\n"
      "  capcon tiles points c2n64 --width 4 --count 10               ten sets of 1024 points on the "
      "torus\n\n"
      "Points are text, one \"x y\" a line with '#' between sets, as `capcon points` writes them.\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, tile_set_help())->required()->type_name("FILE");
  verb->add_option("--width", options->width, "tiles along a side: K; a bounded set takes 2 or more")
      ->capture_default_str()
      ->check(CLI::Range(1, 4096));
  verb->add_option("--ranks", options->ranks, "only the first points of every tile (0: all)")
      ->capture_default_str();
  verb->add_option("--seed", options->seed,
                   "of the first set's corner colours; each further set has the next")
      ->capture_default_str();
  verb->add_option("--count", options->count, "how many sets")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  verb->add_option("-o,--output", options->output, "the file of points (default: standard output)")
      ->type_name("OUT");
  verb->add_flag("-q,--quiet", options->quiet, "no message");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
