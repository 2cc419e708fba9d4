#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "cli/verbs.h"
#include "points/ccvt.h"
#include "points/generators.h"
#include "points/measure.h"

namespace capcon::cli {
namespace {

constexpr std::uint32_t kMostPoints = 100'000'000;  // 1.6 GB

struct Options {
  std::string method;
  GeneratorOptions generator;
  std::string strategy = "global";
  std::string kind = "maximin";
  std::uint32_t count = 1;
  std::string output;
  bool json = false;
  bool quiet = false;
};

/// A whole number in [low, high], said plainly.
CLI::Validator whole(std::uint64_t low, std::uint64_t high) {
  return CLI::Validator(
      [low, high](std::string& text) -> std::string {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high)
          return {};
        return fmt::format("\"{}\" is not a whole number from {} to {}", text, low, high);
      },
      "");
}

/// Processor seconds of all threads of this process.
double cpu_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Options that mean something to some methods only.
struct Only {
  const char* option;
  std::vector<std::string_view> methods;
};
const Only kOnly[] = {{"--capacity", {"ccvt"}},
                      {"--strategy", {"fpo"}},
                      {"--rounds", {"lloyd"}},
                      {"--kind", {"lattice"}},
                      {"--shift", {"lattice"}}};

bool is_for(const Only& only, std::string_view method) {
  return std::find(only.methods.begin(), only.methods.end(), method) != only.methods.end();
}

/// Refuses options that would change nothing. A name that is not a method's gets its own message later.
void check_options(const CLI::App& verb, const std::string& method) {
  for (const Only& only : kOnly) {
    if (verb.get_option(only.option)->count() > 0 && !is_for(only, method)) {
      throw InputError(fmt::format("{} means nothing to {}; it is for {}", only.option, method,
                                   fmt::join(only.methods, ", ")));
    }
  }
}

std::vector<Points> make_sets(const Options& options) {
  std::vector<Points> sets;
  Progress progress("points", options.count, options.quiet);
  for (std::uint32_t s = 0; s < options.count; ++s) {
    GeneratorOptions generator = options.generator;
    generator.strategy =
        options.strategy == "local" ? FpoOptions::Strategy::kLocal : FpoOptions::Strategy::kGlobal;
    generator.kind = options.kind == "golden" ? LatticeKind::kGolden : LatticeKind::kMaximin;
    generator.seed += s;
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

void run(const Options& options) {
  if (!options.output.empty()) check_writable(options.output);
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const std::vector<Points> sets = make_sets(options);
  nlohmann::json seconds = {{"wall", wall_seconds() - wall}, {"cpu", cpu_seconds() - cpu}};
  if (!options.output.empty()) write_points(options.output, sets);
  if (!options.json) {
    if (options.output.empty()) {
      fmt::print("{}", format_points(sets));
    } else if (!options.quiet) {
      const Measures first = measure(sets.front());
      fmt::print(stderr, "{}: {} x {} points in {:.2f} s, energy {:.4f}, mean distance {:.3f}\n",
                 options.output, sets.size(), options.generator.n, seconds["wall"].get<double>(),
                 first.energy, first.delta_mean);
    }
    return;
  }
  nlohmann::ordered_json result = {{"method", options.method}, {"n", options.generator.n}};
  result["seed"] = options.generator.seed;
  if (options.method == "ccvt") result["capacity"] = options.generator.capacity;
  if (options.method == "fpo") result["strategy"] = options.strategy;
  if (options.method == "lloyd") result["rounds"] = options.generator.rounds;
  if (options.method == "lattice") {
    result["kind"] = options.kind;
    result["shift"] = options.generator.shift;
  }
  result["seconds"] = seconds;
  if (!options.output.empty()) result["output"] = options.output;
  std::vector<Measures> measures;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const Measures& m = measures.emplace_back(measure(sets[s]));
    list.push_back({{"seed", options.generator.seed + s}, {"measures", capcon::to_json(m)}});
    if (options.output.empty()) list.back()["points"] = to_json(sets[s]);
  }
  result["measures"] = capcon::to_json(mean_of(measures));
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
      "  capcon points sobol-owen -n 256 --count 10   ten sets, with seeds 1 to 10\n\n"
      "Points are text, one \"x y\" a line with '#' between sets (the form of UTK).\n");
  auto options = std::make_shared<Options>();
  verb->add_option("method", options->method, fmt::format("one of {}", fmt::join(generator_names(), ", ")))
      ->required()
      ->type_name("METHOD");
  verb->add_option("-n,--points", options->generator.n, "points a set")
      ->check(whole(1, kMostPoints))
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("-o,--output", options->output, "write to this file")->type_name("FILE");
  verb->add_option("--capacity", options->generator.capacity,
                   "space points a site (ccvt): more is more even and slower, try 64 to 1024")
      ->check(whole(1, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("K")
      ->capture_default_str();
  verb->add_option(
          "--strategy", options->strategy,
          "where a point may go (fpo): anywhere, or only about its place, which is a little less even")
      ->check(CLI::IsMember({"global", "local"}))
      ->capture_default_str();
  verb->add_option("--rounds", options->generator.rounds, "moves to the centroids (lloyd)")
      ->check(whole(0, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("ROUNDS")
      ->capture_default_str();
  verb->add_option("--kind", options->kind,
                   "which lattice: of largest minimum distance, or of the golden ratio")
      ->check(CLI::IsMember({"maximin", "golden"}))
      ->capture_default_str();
  verb->add_flag("--shift", options->generator.shift, "move the lattice at random, by the seed");
  verb->add_option("--seed", options->generator.seed, "of the first set; each further set has the next")
      ->check(whole(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("S")
      ->capture_default_str();
  verb->add_option("--count", options->count, "how many sets")
      ->check(whole(1, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("SETS")
      ->capture_default_str();
  verb->add_flag("--json", options->json,
                 "print one JSON object: what was made, seconds, measures (means over the sets, and of each "
                 "set), and the "
                 "points unless they go to a file");
  verb->add_flag("--quiet", options->quiet, "no progress, no message");
  verb->callback([options, verb] {
    check_options(*verb, options->method);
    run(*options);
  });
}

}  // namespace capcon::cli
