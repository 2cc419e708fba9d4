#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/tiles_verb.h"
#include "cli/verbs.h"
#include "points/measure.h"
#include "points/partition.h"
#include "tiling/tiling.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string input, tiles, output;
  std::uint32_t width = 8;
  std::uint64_t tiling = 1;
  PartitionOptions partition;
  bool json = false, quiet = false;
};

Points input_points(const Options& o) {
  if (o.input.empty() == o.tiles.empty())
    throw InputError("say what to cut: a file of points, or a tile set with --tiles");
  if (!o.tiles.empty()) {
    const TileSet set = named_tile_set(o.tiles);
    const GaussianTiling tiling(o.width, 0);
    return tile_points(set, tiling, random_colours(tiling, set, o.tiling), set.points_per_tile);
  }
  const std::vector<Points> sets = read_points(o.input);
  if (sets.size() != 1)
    throw InputError(fmt::format("{}: holds {} sets; give a file with one", o.input, sets.size()));
  return sets[0];
}

void run(const Options& o) {
  if (!o.output.empty()) check_writable(o.output);
  const Points points = input_points(o);
  const auto subsets = split(points, partition(points, o.partition), o.partition.subsets);
  if (!o.output.empty()) write_points(o.output, subsets);
  nlohmann::ordered_json measures = nlohmann::ordered_json::array();
  double sum = 0, worst = 1e300;
  for (const Points& subset : subsets) {
    const Measures m = measure(subset);
    measures.push_back(to_json(m));
    sum += m.delta_mean;
    worst = std::min(worst, m.delta_mean);
  }
  const double mean = sum / static_cast<double>(subsets.size());
  if (o.json) {
    nlohmann::ordered_json result = {{"input", o.tiles.empty() ? o.input : o.tiles}};
    if (!o.tiles.empty()) result["tiles"] = o.width * o.width;
    result.update({{"n", points.size()},
                   {"subsets", o.partition.subsets},
                   {"seed", o.partition.seed},
                   {"delta_mean", mean},
                   {"delta_mean_worst", worst},
                   {"sets", measures}});
    fmt::print("{}\n", result.dump(2));
  } else if (o.output.empty()) {
    fmt::print("{}", format_points(subsets));
  } else if (!o.quiet) {
    fmt::print(stderr, "{}: {} points in {} subsets, delta_mean {:.3f}, worst {:.3f}\n", o.output,
               points.size(), subsets.size(), mean, worst);
  }
}

}  // namespace

void add_partition_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("partition", "Cut a point set into subsets that are each well spread");
  auto o = std::make_shared<Options>();
  verb->footer(
      "The subsets are written one after another, '#' between them; their union is the input.\n"
      "Examples: capcon points ccvt -n 1024 -o p.txt && capcon partition p.txt -k 8 -o parts.txt\n"
      "          capcon partition --tiles shipped --width 8 -k 16 -o parts.txt");
  verb->add_option("file", o->input, "Point set: one \"x y\" a line");
  verb->add_option("--tiles", o->tiles,
                   "Cut a random tiling instead, of this tile set: a file, or c2n16, c2n64, c3n16-compact");
  verb->add_option("--width", o->width, "Tiles along the tiling's side")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  verb->add_option("--tiling", o->tiling, "Seed of the tiling's corner colours")->capture_default_str();
  verb->add_option("-k,--subsets", o->partition.subsets, "How many subsets")->capture_default_str();
  verb->add_option("--seed", o->partition.seed, "Seed of the labels it starts from")->capture_default_str();
  verb->add_option("-o,--output", o->output, "File to write; default: standard output");
  verb->add_flag("--json", o->json, "Measures of each subset as JSON on stdout, instead of points");
  verb->add_flag("--quiet", o->quiet, "No messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
