#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "cli/tiles_verb.h"
#include "tiling/even_cells.h"
#include "tiling/tile_report.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string file;
  std::uint32_t tilings = 20, capacity = 1024, untiled_sets = 2;
  bool json = false, quiet = false;
};

TileReport examine(const TileSet& set, const Options& options) {
  Progress progress("verify", 1, options.quiet);
  TileReportOptions report_options;
  report_options.tilings = options.tilings;
  report_options.untiled_sets = options.untiled_sets;
  report_options.capacity = options.capacity;
  report_options.farthest = is_farthest(set);
  report_options.on_progress = [&](double done) { progress.update(done); };
  return examine_tiles(set, report_options);
}

std::size_t shared_points(const TileSet& set) {
  std::size_t count = 0;
  for (const auto& tile : set.tiles)
    count += std::count_if(tile.begin(), tile.end(),
                           [](const TileSet::TilePoint& p) { return p.kind != RegionKind::interior; });
  return count;
}

bool is_good(const TileReport& report) {
  return report.as_good_as_untiled() && report.without_spikes();
}

std::string untiled_name(const TileSet& set, const Options& options) {
  return is_farthest(set) ? fmt::format("{} farthest-point sets", options.untiled_sets)
                          : fmt::format("{} ccvt sets{}, capacity {}", options.untiled_sets,
                                        set.bounded() ? " of the square" : "", options.capacity);
}

void print_json(const TileSet& set, const Options& options, const TileReport& report) {
  nlohmann::ordered_json result = {{"file", options.file},
                                   {"colours", set.colours},
                                   {"colouring", colouring_name(set.colouring)},
                                   {"tiles", set.tile_count()},
                                   {"points_per_tile", set.points_per_tile},
                                   {"shared_points", shared_points(set)},
                                   {"recipe", set.recipe},
                                   {"checksum", fmt::format("{:016x}", checksum(set))}};
  for (const TilingFigures& f : report.tilings) result["tilings"].push_back(to_json(f));
  for (const TilingFigures& f : report.alone) result["prefixes_of_one_tile"].push_back(to_json(f));
  for (const TilingFigures& f : report.prefixes) result["prefixes"].push_back(to_json(f));
  result["untiled"] = {{"method", is_farthest(set) ? "fpo" : "ccvt"}, {"sets", options.untiled_sets}};
  if (!is_farthest(set)) result["untiled"]["capacity"] = options.capacity;
  result["untiled"].update(to_json(report.untiled));
  result["energy_ratio"] = report.energy_ratio;
  result["delta_mean_ratio"] = report.delta_mean_ratio;
  result["tolerance"] = TileReport::kTolerance;
  result["spike"] = {{"kx", report.spike.kx},
                     {"ky", report.spike.ky},
                     {"power", report.spike.power},
                     {"local_mean", report.spike.around},
                     {"ratio", report.spike.ratio()}};
  result["least_prefix_delta_mean"] = report.worst_prefix().delta_mean;
  result["well_ranked"] = report.well_ranked();
  if (set.bounded()) result["even_cells"] = !find_shared_cell(set);
  result["ok"] = is_good(report);
  fmt::print("{}\n", result.dump(2));
}

void print_text(const TileSet& set, const Options& options, const TileReport& report) {
  fmt::print("{}: {} tiles of {} points, {} of them shared with other tiles, checksum {:016x}\n",
             options.file, set.tile_count(), set.points_per_tile, shared_points(set), checksum(set));
  fmt::print("made by: {}\n\n", set.recipe);
  fmt::print("{:<22} {:>6} {:>8} {:>8} {:>11} {:>8} {:>10}\n", "", "points", "energy", "+-", "delta_mean",
             "+-", "delta_min");
  const auto row = [](const std::string& name, const TilingFigures& f) {
    fmt::print("{:<22} {:>6} {:>8.4f} {:>8.4f} {:>11.4f} {:>8.4f} {:>10.4f}\n", name, f.tiles * f.ranks,
               f.energy, f.energy_sd, f.delta_mean, f.delta_mean_sd, f.delta_min);
  };
  for (const TilingFigures& f : report.tilings)
    row(fmt::format("{} tile{}", f.tiles, f.tiles == 1 ? "" : "s"), f);
  for (const TilingFigures& f : report.alone)
    if (f.ranks < set.points_per_tile) row(fmt::format("first {} of 1 tile", f.ranks), f);
  fmt::print("{:<22} {:>6} {:>8.4f} {:>8} {:>11.4f} {:>8} {:>10.4f}   ({})\n", "untiled", report.untiled.n,
             report.untiled.energy, "", report.untiled.delta_mean, "", report.untiled.delta_min,
             untiled_name(set, options));
  fmt::print("\n{} tiles against untiled: energy {:+.2f} %, delta_mean {:+.2f} %: {}\n",
             report.tilings.back().tiles, 100 * (report.energy_ratio - 1),
             100 * (report.delta_mean_ratio - 1),
             report.as_good_as_untiled() ? "good" : "worse by more than 3 %");
  const std::uint32_t side = TileReport::kSide;
  const TilingFigures& least = report.worst_prefix();
  fmt::print("prefixes of 1 to {} points in {}x{} tilings: least delta_mean {:.3f}, at {} point{}: {}\n",
             set.points_per_tile, side, side, least.delta_mean, least.ranks, least.ranks == 1 ? "" : "s",
             report.well_ranked() ? "good" : fmt::format("below {:.2f}", TileReport::kPrefix));
  const Spike& spike = report.spike;
  fmt::print(
      "spectrum at multiples of the tile frequency: at most {:.2f} times the local mean, at ({}, {}): {}\n",
      spike.ratio(), spike.kx / int(side), spike.ky / int(side),
      report.without_spikes() ? "good" : fmt::format("above {:g}", TileReport::kSpike));
  if (!set.bounded()) return;
  const auto shared = find_shared_cell(set);
  fmt::print("cells of random places in tilings without a bias: {}\n",
             shared ? fmt::format("point {} of tile {} has another point's", shared->second, shared->first)
                    : "one for every point");
}

void run(const Options& options) {
  const TileSet set =
      named_tile_set(options.file);  // proves the checksum and that copies of regions are alike
  const TileReport report = examine(set, options);
  options.json ? print_json(set, options, report) : print_text(set, options, report);
  if (!report.as_good_as_untiled())
    throw Failure(
        fmt::format("{}: tilings of this set are more than 3 % worse than untiled points", options.file));
  if (!report.without_spikes())
    throw Failure(
        fmt::format("{}: the spectrum of its tilings has a spike at the tile frequency", options.file));
}

}  // namespace

void add_tiles_verify(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand(
      "verify",
      "prove a tile set whole and measure random tilings of it against untiled points\n\n"
      "Checks the checksum, that every tile holds its points and that copies of a shared region are alike; "
      "then\n"
      "measures tilings that were not optimised on: their evenness, that of the first points of every tile, "
      "and\n"
      "what repeats in every tile. Exit code 1 when tilings of about 1024 points are more than 3 % worse "
      "than points\n"
      "made without tiles, in energy or in mean distance, or when their mean spectrum is more than 3 times "
      "its\n"
      "surroundings at a multiple of the tile frequency.\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, tile_set_help())->required()->type_name("FILE");
  verb->add_option("--tilings", options->tilings, "random tilings of each size")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  verb->add_option("--capacity", options->capacity, "space points a site of the untiled points")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536));
  verb->add_option("--untiled", options->untiled_sets, "untiled sets to compare with")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  verb->add_flag("--json", options->json, "print one JSON object");
  verb->add_flag("-q,--quiet", options->quiet, "no progress bar");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
