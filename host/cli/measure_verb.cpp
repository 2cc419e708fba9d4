#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/verbs.h"
#include "points/measure.h"
#include "points/point_set.h"

namespace capcon::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  bool json = false;
};

struct Row {
  std::string file;
  std::size_t set;
  Measures measures;
};

void run(const Options& options) {
  std::vector<Row> rows;  // all files first: an error leaves no half table
  for (const std::string& file : options.files) {
    std::size_t set = 0;
    for (const Points& points : read_points(file)) rows.push_back({file, ++set, measure(points)});
  }
  if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
      nlohmann::ordered_json entry = {{"file", row.file}, {"set", row.set}};
      entry.update(to_json(row.measures));
      list.push_back(entry);
    }
    fmt::print("{}\n", list.dump(2));
    return;
  }
  std::size_t width = 4;
  for (const Row& row : rows) width = std::max(width, row.file.size());
  fmt::print("{:<{}} {:>5} {:>8} {:>10} {:>10} {:>8} {:>8}\n", "file", width, "set", "n", "delta_min",
             "delta_mean", "energy", "area_sd");
  for (const Row& row : rows) {
    const Measures& m = row.measures;
    fmt::print("{:<{}} {:>5} {:>8} {:>10.4f} {:>10.4f} {:>8.4f} {:>8.4f}\n", row.file, width, row.set, m.n,
               m.delta_min, m.delta_mean, m.energy, m.area_sd);
  }
}

}  // namespace

void add_measure_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("measure",
                                      "how even point sets are\n\n"
                                      "  capcon measure points.txt\n\n"
                                      "A row a set, all on the torus (the square's edges meet):\n"
                                      "  delta_min   smallest distance of two points, 1 = hexagonal lattice\n"
                                      "  delta_mean  mean distance to the nearest point, likewise\n"
                                      "  energy      mean squared distance of the square to its nearest "
                                      "point, 1 = hexagonal lattice, the least\n"
                                      "  area_sd     standard deviation of the Voronoi cells' areas, 0 = all "
                                      "alike, about 0.53 for random points\n");
  auto options = std::make_shared<Options>();
  verb->add_option("files", options->files, "text files of points, one \"x y\" a line, '#' between sets")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--json", options->json, "print one JSON array, an object a set (numbering from 1)");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
