#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "cli/tiles_verb.h"
#include "points/ccvt.h"
#include "points/measure.h"
#include "tiling/region_layout.h"
#include "tiling/tile_quality.h"

namespace capcon::cli {
namespace {

constexpr double kTolerance = 0.03;       // how much worse than untiled points a set may be
constexpr std::uint32_t kUntiled = 1024;  // points of the comparison, about

struct Options {
  std::string file;
  std::uint32_t tilings = 20, capacity = 1024, untiled_sets = 2;
  bool json = false, quiet = false;
};

struct Report {
  std::vector<TilingFigures> tilings;   // 1, 2, 4, 8, 16 and at last side x side tiles
  std::vector<TilingFigures> prefixes;  // of one tile: 1, 2, 4, ... points
  Measures untiled;                     // mean of the sets
  double energy_ratio = 0, delta_mean_ratio = 0;
  std::size_t shared = 0;  // places that hold copies of points also found in other tiles
  bool ok = false;
};

Measures untiled_points(const Options& options, std::uint32_t sites, Progress& progress) {
  Measures mean;
  mean.n = sites;
  for (std::uint32_t s = 0; s < options.untiled_sets; ++s) {
    CcvtOptions ccvt_options;
    ccvt_options.sites = sites;
    ccvt_options.capacity = options.capacity;
    ccvt_options.seed = s + 1;
    ccvt_options.on_progress = [&](double fraction) { progress.update(s + fraction, "untiled points"); };
    const Measures m = measure(ccvt(ccvt_options).points);
    mean.energy += m.energy / options.untiled_sets;
    mean.delta_mean += m.delta_mean / options.untiled_sets;
    mean.delta_min += m.delta_min / options.untiled_sets;
    mean.area_sd += m.area_sd / options.untiled_sets;
  }
  return mean;
}

Report examine(const TileSet& set, const Options& options) {
  Report report;
  const std::uint32_t nt = set.points_per_tile;
  const auto side = std::max(2u, std::uint32_t(std::lround(std::sqrt(double(kUntiled) / nt))));
  Progress progress("verify", options.untiled_sets + 1, options.quiet);
  report.untiled = untiled_points(options, side * side * nt, progress);
  const std::pair<std::uint32_t, std::uint32_t> shapes[] = {{1, 0}, {1, 1}, {2, 0},
                                                            {2, 2}, {4, 0}, {side, 0}};
  for (const auto& [a, b] : shapes)
    report.tilings.push_back(tiling_figures(set, a, b, nt, options.tilings, 1));
  for (std::uint32_t r = 1; r <= nt; r *= 2)
    report.prefixes.push_back(tiling_figures(set, 1, 0, r, options.tilings, 1));
  for (const auto& tile : set.tiles)
    report.shared += std::count_if(
        tile.begin(), tile.end(), [](const TileSet::TilePoint& p) { return p.kind != RegionKind::interior; });
  report.energy_ratio = report.tilings.back().energy / report.untiled.energy;
  report.delta_mean_ratio = report.tilings.back().delta_mean / report.untiled.delta_mean;
  report.ok = report.energy_ratio <= 1 + kTolerance && report.delta_mean_ratio >= 1 - kTolerance;
  return report;
}

void print_json(const TileSet& set, const Options& options, const Report& report) {
  nlohmann::ordered_json result = {{"file", options.file},
                                   {"colours", set.colours},
                                   {"tiles", set.tile_count()},
                                   {"points_per_tile", set.points_per_tile},
                                   {"shared_points", report.shared},
                                   {"recipe", set.recipe},
                                   {"checksum", fmt::format("{:016x}", checksum(set))}};
  for (const TilingFigures& f : report.tilings) result["tilings"].push_back(to_json(f));
  for (const TilingFigures& f : report.prefixes) result["prefixes"].push_back(to_json(f));
  result["untiled"] = {{"method", "ccvt"}, {"capacity", options.capacity}, {"sets", options.untiled_sets}};
  result["untiled"].update(to_json(report.untiled));
  result["energy_ratio"] = report.energy_ratio;
  result["delta_mean_ratio"] = report.delta_mean_ratio;
  result["tolerance"] = kTolerance;
  result["ok"] = report.ok;
  fmt::print("{}\n", result.dump(2));
}

void print_text(const TileSet& set, const Options& options, const Report& report) {
  fmt::print("{}: {} tiles of {} points, {} of them shared with other tiles, checksum {:016x}\n",
             options.file, set.tile_count(), set.points_per_tile, report.shared, checksum(set));
  fmt::print("made by: {}\n\n", set.recipe);
  fmt::print("{:<22} {:>6} {:>8} {:>8} {:>11} {:>8}\n", "", "points", "energy", "+-", "delta_mean", "+-");
  const auto row = [](const std::string& name, const TilingFigures& f) {
    fmt::print("{:<22} {:>6} {:>8.4f} {:>8.4f} {:>11.4f} {:>8.4f}\n", name, f.tiles * f.ranks, f.energy,
               f.energy_sd, f.delta_mean, f.delta_mean_sd);
  };
  for (const TilingFigures& f : report.tilings)
    row(fmt::format("{} tile{}", f.tiles, f.tiles == 1 ? "" : "s"), f);
  for (const TilingFigures& f : report.prefixes)
    if (f.ranks < set.points_per_tile) row(fmt::format("first {} of 1 tile", f.ranks), f);
  fmt::print("{:<22} {:>6} {:>8.4f} {:>8} {:>11.4f}   ({} ccvt sets, capacity {})\n", "untiled",
             report.untiled.n, report.untiled.energy, "", report.untiled.delta_mean, options.untiled_sets,
             options.capacity);
  fmt::print("\n{} tiles against untiled: energy {:+.2f} %, delta_mean {:+.2f} %: {}\n",
             report.tilings.back().tiles, 100 * (report.energy_ratio - 1),
             100 * (report.delta_mean_ratio - 1), report.ok ? "good" : "worse by more than 3 %");
}

void run(const Options& options) {
  const TileSet set =
      named_tile_set(options.file);  // proves the checksum and that copies of regions are alike
  const Report report = examine(set, options);
  options.json ? print_json(set, options, report) : print_text(set, options, report);
  if (!report.ok)
    throw Failure(
        fmt::format("{}: tilings of this set are more than 3 % worse than untiled points", options.file));
}

}  // namespace

void add_tiles_verify(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand(
      "verify",
      "prove a tile set whole and measure random tilings of it against untiled points\n\n"
      "Checks the checksum, that every tile holds its points and that copies of a shared region are alike; "
      "then\n"
      "measures tilings that were not optimised on. Exit code 1 when 64 tiles (1024 points) are more than 3 "
      "% worse\n"
      "than capacity-constrained points made without tiles, in energy or in mean distance.\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, "a tile set's file, or: shipped")->required()->type_name("FILE");
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
