#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "cli/density_option.h"
#include "cli/points_options.h"
#include "cli/verbs.h"
#include "points/import_points.h"
#include "points/measure.h"
#include "points/transport.h"

namespace capcon::cli {
namespace {

using Options = PointsOptions;

/// Processor seconds of all threads of this process.
double cpu_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// `stopped` becomes true when the time limit cut a set short.
std::vector<Points> make_sets(const Options& options, bool& stopped) {
  if (options.method == "import") return import_points(options.file);
  std::vector<Points> sets;
  Region region;
  if (options.domain != "torus") region.domain = options.domain == "disk" ? Domain::kDisk : Domain::kSquare;
  if (!options.density.empty()) region.density = read_density(options.density);
  if (options.finish == "transport" && (region.density || region.domain == Domain::kDisk)) {
    throw InputError(
        "--finish transport is for even points on the torus or the square; leave out --density and --domain "
        "disk");
  }
  const double end = wall_seconds() + options.time_limit;
  Progress progress("points", options.count, options.quiet);
  for (std::uint32_t s = 0; s < options.count; ++s) {
    GeneratorOptions generator = options.generator;
    generator.strategy =
        options.strategy == "local" ? FpoOptions::Strategy::kLocal : FpoOptions::Strategy::kGlobal;
    generator.kind = options.kind == "golden" ? LatticeKind::kGolden : LatticeKind::kMaximin;
    generator.seed += s;
    generator.region = region;
    generator.finish = options.finish == "transport";
    if (options.time_limit > 0) {
      generator.stop = [&stopped, end] {
        const bool late = wall_seconds() >= end;
        stopped = stopped || late;
        return late;
      };
    }
    generator.on_progress = [&](double fraction) { progress.update(s + fraction); };
    sets.push_back(generate(options.method, generator));
    progress.update(s + 1);
  }
  return sets;
}

nlohmann::json to_json(const Points& points) {
  nlohmann::json list = nlohmann::json::array();
  for (const glm::dvec2& p : points) list.push_back({p.x, p.y});
  return list;
}

/// What was asked for, defaults included.
nlohmann::ordered_json parameters(const Options& options) {
  if (options.method == "import") return {{"method", "import"}, {"file", options.file}};
  nlohmann::ordered_json result = {{"method", options.method}, {"n", options.generator.n}};
  result["seed"] = options.generator.seed;
  if (options.method == "ccvt") {
    result["capacity"] = options.generator.capacity;
    result["finish"] = options.finish;
  }
  if (options.method == "fpo") result["strategy"] = options.strategy;
  if (options.method == "lloyd") result["rounds"] = options.generator.rounds;
  if (options.method == "lattice") {
    result["kind"] = options.kind;
    result["shift"] = options.generator.shift;
  }
  if (!options.density.empty()) result["density"] = options.density;
  if (options.domain != "torus") result["domain"] = options.domain;
  return result;
}

/// The measures are those of even points on the torus: they say nothing about others.
bool are_measured(const Options& options) {
  return options.density.empty() && options.domain == "torus";
}

/// With the transport energy where that is what was optimised, and it does not take longer than the points.
Measures measured(const Options& options, const Points& points) {
  Measures measures = measure(points);
  if (options.method == "ccvt" && points.size() <= kFullMeasureLimit)
    measures.energy_ot = transport_energy(points);
  return measures;
}

std::string summary(const Options& options, const std::vector<Points>& sets, double seconds) {
  const std::string made = fmt::format("{}: {} x {} points in {:.2f} s", options.output, sets.size(),
                                       sets.front().size(), seconds);
  if (!are_measured(options)) return made;
  const Measures first = measured(options, sets.front());
  const std::string transport =
      std::isnan(first.energy_ot) ? "" : fmt::format(", transport energy {:.4f}", first.energy_ot);
  return fmt::format("{}, energy {:.4f}{}, mean distance {:.3f}", made, first.energy, transport,
                     first.delta_mean);
}

void run(const Options& options) {
  if (!options.output.empty()) check_writable(options.output);
  const double wall = wall_seconds(), cpu = cpu_seconds();
  bool stopped = false;
  const std::vector<Points> sets = make_sets(options, stopped);
  if (stopped && !options.quiet)
    fmt::print(stderr,
               "stopped after {} s, before the end: the points are valid, yet less even than they could be\n",
               options.time_limit);
  nlohmann::json seconds = {{"wall", wall_seconds() - wall}, {"cpu", cpu_seconds() - cpu}};
  if (!options.output.empty()) write_points(options.output, sets);
  if (!options.json) {
    if (options.output.empty()) {
      fmt::print("{}", format_points(sets));
    } else if (!options.quiet) {
      fmt::print(stderr, "{}\n", summary(options, sets, seconds["wall"].get<double>()));
    }
    return;
  }
  nlohmann::ordered_json result = parameters(options);
  result["seconds"] = seconds;
  if (options.time_limit > 0) result["stopped"] = stopped;
  if (!options.output.empty()) result["output"] = options.output;
  std::vector<Measures> measures;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    nlohmann::ordered_json entry = {{"n", sets[s].size()}};
    if (options.method != "import") entry["seed"] = options.generator.seed + s;
    if (are_measured(options))
      entry["measures"] = capcon::to_json(measures.emplace_back(measured(options, sets[s])));
    if (options.output.empty()) entry["points"] = to_json(sets[s]);
    list.push_back(entry);
  }
  if (are_measured(options)) result["measures"] = capcon::to_json(mean_of(measures));
  result["sets"] = list;
  fmt::print("{}\n", result.dump());
}

}  // namespace

void add_points_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "points",
      "make point sets in the unit square\n\n"
      "  capcon points ccvt -n 1024 -o points.txt     capacity-constrained points, best quality\n"
      "  capcon points ccvt -n 4096 --capacity 64     faster, a little less even; points to standard output\n"
      "  capcon points ccvt --finish transport        the most even, and faster than a high capacity\n"
      "  capcon points sobol-owen -n 256 --count 10   ten sets, with seeds 1 to 10\n"
      "  capcon points ccvt --density photo.png       more points where the image is bright\n"
      "  capcon points ccvt --density 'x^2 + 0.1'     ... or where the formula is large\n"
      "  capcon points lloyd --domain disk            in the disk of radius 1/2, nothing wraps around\n"
      "  capcon points import other.csv -o points.txt points of other programs: CSV, NumPy, UTK text, "
      ".bin\n\n"
      "Points are text, one \"x y\" a line with '#' between sets (the form of UTK).\n");
  auto options = std::make_shared<Options>();
  add_points_options(*verb, *options);
  verb->callback([options, verb] {
    check_points_options(*verb, options->method);
    run(*options);
  });
}

}  // namespace capcon::cli
