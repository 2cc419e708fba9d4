#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/progress.h"
#include "cli/verbs.h"
#include "plot/measure_sheet.h"
#include "plot/picture_file.h"
#include "points/import_points.h"
#include "points/measure.h"
#include "points/spectrum.h"

namespace capcon::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string plot;
  std::size_t columns = 0;
  double scale = 1.5;
  bool json = false, sets = false, all = false;
};

/// What becomes one row: the sets of a file that have as many points, or one set.
struct Group {
  std::string file;
  std::size_t first_set = 1;  ///< from 1
  std::vector<Points> sets;
  std::vector<Measures> each = {};
  Measures mean = {};
  std::optional<Spectrum> spectrum = {};
  RadialSpectrum radial = {};
};

std::vector<Group> read_groups(const Options& options) {
  std::vector<Group> groups;
  for (const std::string& file : options.files) {
    std::size_t set = 0;
    for (Points& points : import_points(file)) {
      const bool goes_on = set++ > 0 && !options.sets && groups.back().sets[0].size() == points.size();
      if (!goes_on) groups.push_back({file, set, {}});
      groups.back().sets.push_back(std::move(points));
    }
  }
  return groups;
}

void measure_groups(const Options& options, std::vector<Group>& groups) {
  const std::size_t limit = options.all ? std::numeric_limits<std::size_t>::max() : kFullMeasureLimit;
  std::size_t total = 0, done = 0;
  for (const Group& group : groups) total += group.sets.size();
  Progress progress("measure", static_cast<double>(total));
  for (Group& group : groups) {
    for (const Points& points : group.sets) {
      group.each.push_back(measure_fully(points, limit));
      progress.update(static_cast<double>(++done));
    }
    group.mean = mean_of(group.each);
    const std::size_t n = group.sets[0].size();
    if ((options.json || !options.plot.empty()) && n <= limit) {
      group.spectrum = power_spectrum(group.sets, default_reach(n));
      group.radial = radial_spectrum(*group.spectrum);
    }
  }
}

void draw(const Options& options, const std::vector<Group>& groups) {
  std::vector<plot::SheetEntry> entries;
  for (const Group& group : groups) {
    const std::string name = std::filesystem::path(group.file).stem().string();
    entries.push_back({options.sets ? fmt::format("{} {}", name, group.first_set) : name, group.sets.size(),
                       group.sets[0], group.mean, group.spectrum, group.radial});
  }
  const plot::MeasureSheet sheet(std::move(entries), options.columns);
  plot::write_picture(
      options.plot, sheet.width(), sheet.height(), [&](plot::Canvas& canvas) { sheet.draw(canvas); },
      options.scale);
}

void print_json(const Options& options, const std::vector<Group>& groups) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Group& group : groups) {
    nlohmann::ordered_json entry = {
        {"file", group.file}, {"set", group.first_set}, {"sets", group.sets.size()}};
    entry.update(to_json(group.mean));
    if (group.each.size() > 1) {
      for (const Measures& measures : group.each) entry["each"].push_back(to_json(measures));
    }
    if (group.spectrum) entry["spectrum"] = to_json(*group.spectrum, group.radial, options.all);
    list.push_back(entry);
  }
  fmt::print("{}\n", list.dump(2));
}

/// Fields of the table; JSON has them all.
bool is_common(std::string_view name) {
  return name != "capacity_error" && name != "centroid_rms" && name != "psi6" && name != "psi6_local";
}

void print_table(const Options& options, const std::vector<Group>& groups) {
  std::size_t width = 4;
  for (const Group& group : groups) width = std::max(width, group.file.size());
  fmt::print("{:<{}} {:>4} {:>7}", "file", width, options.sets ? "set" : "sets", "n");
  for (const MeasureField& field : measure_fields()) {
    if (options.all || is_common(field.name)) fmt::print(" {:>10}", field.name);
  }
  fmt::print("\n");
  for (const Group& group : groups) {
    fmt::print("{:<{}} {:>4} {:>7}", group.file, width, options.sets ? group.first_set : group.sets.size(),
               group.mean.n);
    for (const MeasureField& field : measure_fields()) {
      if (!options.all && !is_common(field.name)) continue;
      const double value = group.mean.*field.value;
      const bool small = std::abs(value) < 0.01 && std::abs(value) > 1e-12;
      fmt::print(" {:>10}", std::isnan(value) ? "-"
                            : small           ? fmt::format("{:.2e}", value)
                                              : fmt::format("{:.4f}", value));
    }
    fmt::print("\n");
  }
}

void run(const Options& options) {
  if (!options.plot.empty()) plot::check_picture_name(options.plot);
  std::vector<Group> groups = read_groups(options);  // all files first: an error leaves no half table
  measure_groups(options, groups);
  if (!options.plot.empty()) draw(options, groups);
  options.json ? print_json(options, groups) : print_table(options, groups);
}

}  // namespace

void add_measure_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "measure",
      "how even point sets are\n\n"
      "  capcon measure points.txt\n"
      "  capcon measure random.txt ccvt.txt --plot sheet.png   cells, spectra, figures side by side\n"
      "  capcon measure sets.txt --json > sets.json            radial spectra too\n\n"
      "A row a file (means over its sets), all on the torus (the square's edges meet):\n"
      "  delta_min   smallest distance of two points, 1 = hexagonal lattice\n"
      "  delta_mean  mean distance to the nearest point, likewise\n"
      "  energy      mean squared distance of the square to its nearest point, 1 = hexagonal lattice, the "
      "least\n"
      "  energy_ot   the same when every point serves an equal share of the square\n"
      "  area_sd     standard deviation of n * area of the Voronoi cells, about 0.53 for random points\n"
      "and, of the square whose edges do not meet:\n"
      "  star        star discrepancy: the most by which the share of points in a box from the origin and "
      "its "
      "area differ\n"
      "  l2_star     the root mean square of that difference\n"
      "docs/measures.md has the formulas and the rest: capacity_error, centroid_rms, psi6, spectra.\n");
  auto options = std::make_shared<Options>();
  verb->add_option("files", options->files,
                   "text files of points, one \"x y\" a line, '#' between sets; or .csv, .bin, .npy")
      ->required()
      ->type_name("FILE");
  verb->add_option("--plot", options->plot, "draw a sheet, a column a row of the table, as .svg or .png")
      ->type_name("OUT");
  verb->add_option("--columns", options->columns, "of the sheet, in one row (default: up to six, rows even)")
      ->check(CLI::Range(1, 64))
      ->type_name("C");
  verb->add_option("--scale", options->scale, "pixels a unit of a PNG; a column is 266 units wide")
      ->check(CLI::Range(0.5, 8.0))
      ->capture_default_str()
      ->type_name("S");
  verb->add_flag("--json", options->json,
                 "print one JSON array, an object a row, with its spectrum by radius");
  verb->add_flag("--sets", options->sets, "a row a set instead of means over a file's sets");
  verb->add_flag(
      "--all", options->all,
      fmt::format("every measure in the table; transport energy, star discrepancy and spectrum beyond "
                  "{} points too, in time that grows with n^2; the whole spectrum in JSON",
                  kFullMeasureLimit));
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
