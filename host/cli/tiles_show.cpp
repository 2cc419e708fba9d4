#include <fmt/format.h>

#include <memory>

#include "base/error.h"
#include "cli/tiles_verb.h"
#include "plot/palette.h"
#include "plot/picture_file.h"
#include "plot/svg_canvas.h"
#include "plot/tiling_panel.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string file, output;
  std::uint32_t width = 4, ranks = 0, size = 800;
  std::uint64_t seed = 1;
};

void run(const Options& options) {
  const TileSet set = named_tile_set(options.file);
  if (!options.output.empty()) plot::check_picture_name(options.output);
  if (options.ranks > set.points_per_tile)
    throw InputError(
        fmt::format("--ranks {}: a tile of this set has {} points", options.ranks, set.points_per_tile));
  if (set.bounded() && options.width < kLeastBoundedSide)
    throw InputError("--width 1: a square with a border takes 2 x 2 tiles or more");
  const double size = options.size;
  const auto draw = [&](plot::Canvas& canvas) {
    plot::draw_tiling(canvas, {0, 0, size, size}, set, {options.width, options.ranks, options.seed});
  };
  if (options.output.empty()) {
    plot::SvgCanvas canvas(size, size, plot::kGround);
    draw(canvas);
    fmt::print("{}", canvas.str());
  } else {
    plot::write_picture(options.output, size, size, draw, 1);
  }
}

}  // namespace

void add_tiles_show(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand("show",
                                        "draw a random tiling: points, their Voronoi cells, tiles and corner "
                                        "colours\n\n"
                                        "  capcon tiles show shipped --width 4 -o tiling.png\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, tile_set_help())->required()->type_name("FILE");
  verb->add_option("--width", options->width, "tiles along a side")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  verb->add_option("--seed", options->seed, "of the corner colours")->capture_default_str();
  verb->add_option("--ranks", options->ranks, "only the first points of every tile (0: all)")
      ->capture_default_str();
  verb->add_option("--size", options->size, "pixels along a side")
      ->capture_default_str()
      ->check(CLI::Range(16, 16384));
  verb->add_option("-o,--output", options->output, ".svg or .png (default: SVG on standard output)")
      ->type_name("FILE");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
