#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "cli/tiles_verb.h"
#include "plot/picture_file.h"
#include "plot/tile_sheet.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string file, output;
  std::uint32_t tilings = 20, untiled_sets = 2, capacity = 1024;
  double scale = 1.5;
  bool quiet = false;
};

void run(const Options& options) {
  plot::check_picture_name(options.output);
  const TileSet set = named_tile_set(options.file);
  TileReportOptions report;
  report.tilings = options.tilings;
  report.untiled_sets = options.untiled_sets;
  report.capacity = options.capacity;
  report.farthest = is_farthest(set);
  const std::string name =
      options.file == "shipped" ? "c2n16" : std::filesystem::path(options.file).stem().string();
  std::unique_ptr<plot::TileSheet> sheet;
  {
    Progress progress("sheet", 1, options.quiet);
    report.on_progress = [&](double done) { progress.update(done); };
    sheet = std::make_unique<plot::TileSheet>(plot::tile_sheet_data(name, set, report));
  }
  plot::write_picture(
      options.output, plot::TileSheet::kWidth, plot::TileSheet::kHeight,
      [&](plot::Canvas& canvas) { sheet->draw(canvas); }, options.scale);
}

}  // namespace

void add_tiles_sheet(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand(
      "sheet",
      "draw the quality of a tile set on one page\n\n"
      "  capcon tiles sheet c2n64 -o sheet.png\n\n"
      "Tilings of 4 x 4, 8 x 8 and 16 x 16 tiles with their figures against points made without tiles, the "
      "mean spectrum\n"
      "with the tile frequency marked, its radial mean, and the mean distance of every prefix of the "
      "ranks.\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, tile_set_help())->required()->type_name("FILE");
  verb->add_option("-o,--output", options->output, ".svg or .png")->required()->type_name("OUT");
  verb->add_option("--tilings", options->tilings, "random tilings in every mean and in the spectrum")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  verb->add_option("--untiled", options->untiled_sets, "untiled sets to compare with")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  verb->add_option("--capacity", options->capacity, "space points a site of the untiled points")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536));
  verb->add_option("--scale", options->scale, "pixels a unit of a PNG; the page is 1010 units wide")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 8.0));
  verb->add_flag("-q,--quiet", options->quiet, "no progress bar");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
