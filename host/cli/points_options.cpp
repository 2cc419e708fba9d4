#include "cli/points_options.h"
#include "cli/positive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/error.h"

namespace capcon::cli {
namespace {

constexpr std::uint32_t kMostPoints = 100'000'000;  // 1.6 GB

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

/// Options that mean something to some methods only.
struct Only {
  const char* option;
  std::vector<std::string> methods;
};
const Only kOnly[] = {{"--capacity", {"ccvt"}},
                      {"--finish", {"ccvt"}},
                      {"--time-limit", {"ccvt"}},
                      {"--strategy", {"fpo"}},
                      {"--rounds", {"lloyd"}},
                      {"--kind", {"lattice"}},
                      {"--shift", {"lattice"}},
                      {"--density", {"ccvt", "lloyd", "random", "jittered"}},
                      {"--domain", {"ccvt", "lloyd", "random", "jittered"}},
                      {"FILE", {"import"}},
                      {"-n", generator_names()},
                      {"--seed", generator_names()},
                      {"--count", generator_names()}};

}  // namespace

void check_points_options(const CLI::App& verb, const std::string& method) {
  const auto has = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), method) != list.end();
  };
  if (method != "import" && !has(generator_names())) {
    throw InputError(fmt::format("no method \"{}\"; there are {}, and import FILE", method,
                                 fmt::join(generator_names(), ", ")));
  }
  for (const Only& only : kOnly) {
    const std::string name = only.option[0] == '-' ? only.option : "file";
    if (verb.get_option(name)->count() > 0 && !has(only.methods)) {
      throw InputError(method == "import" ? fmt::format("{} means nothing to import", only.option)
                                          : fmt::format("{} means nothing to {}; it is for {}", only.option,
                                                        method, fmt::join(only.methods, ", ")));
    }
  }
  if (method == "import" && verb.get_option("file")->count() == 0)
    throw InputError("import which file? Give its name: capcon points import FILE");
}

void add_points_options(CLI::App& verb, PointsOptions& options) {
  verb.add_option("method", options.method,
                  fmt::format("one of {}, import", fmt::join(generator_names(), ", ")))
      ->required()
      ->type_name("METHOD");
  verb.add_option("file", options.file, "what to import")->type_name("FILE");
  verb.add_option("-n,--points", options.generator.n, "points a set")
      ->check(whole(1, kMostPoints))
      ->type_name("N")
      ->capture_default_str();
  verb.add_option("-o,--output", options.output, "write to this file")->type_name("FILE");
  verb.add_option("--capacity", options.generator.capacity,
                  "space points a site (ccvt): more is more even and slower, try 64 to 1024")
      ->check(whole(1, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("K")
      ->capture_default_str();
  verb.add_option(
          "--finish", options.finish,
          "none: ends when a pass over all pairs of sites exchanges nothing (ccvt). transport: goes on from "
          "capacity 64 with power cells of exactly equal area, each site to the centroid of its own, until "
          "20 rounds lower the energy by less than 0.04 %; faster and more even than any capacity; on the "
          "torus and in the square")
      ->check(CLI::IsMember({"none", "transport"}))
      ->capture_default_str();
  verb.add_option(
          "--time-limit", options.time_limit,
          "end after this many seconds, at the next pass, with what there is: capacities hold, at a lower "
          "capacity if need be (ccvt)")
      ->check(positive_number())
      ->type_name("SECONDS");
  verb.add_option(
          "--density", options.density,
          "an image (.exr, .png: its luminance, top row at y = 0) or a formula of x and y: + - * / ^ ( ) sin "
          "cos exp log sqrt abs min max pow pi e (ccvt, lloyd, random, jittered)")
      ->type_name("IMAGE|FORMULA");
  verb.add_option("--domain", options.domain,
                  "torus (the sides meet), square, or disk of radius 1/2 about (1/2, 1/2) (the same methods)")
      ->check(CLI::IsMember({"torus", "square", "disk"}))
      ->capture_default_str();
  verb.add_option(
          "--strategy", options.strategy,
          "where a point may go (fpo): anywhere, or only about its place, which is a little less even")
      ->check(CLI::IsMember({"global", "local"}))
      ->capture_default_str();
  verb.add_option("--rounds", options.generator.rounds, "moves to the centroids (lloyd)")
      ->check(whole(0, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("ROUNDS")
      ->capture_default_str();
  verb.add_option("--kind", options.kind,
                  "which lattice: of largest minimum distance, or of the golden ratio")
      ->check(CLI::IsMember({"maximin", "golden"}))
      ->capture_default_str();
  verb.add_flag("--shift", options.generator.shift, "move the lattice at random, by the seed");
  verb.add_option("--seed", options.generator.seed, "of the first set; each further set has the next")
      ->check(whole(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("S")
      ->capture_default_str();
  verb.add_option("--count", options.count, "how many sets")
      ->check(whole(1, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("SETS")
      ->capture_default_str();
  verb.add_flag("--json", options.json,
                "print one JSON object: what was made, seconds, measures (means over the sets, and of each "
                "set), and the "
                "points unless they go to a file");
  verb.add_flag("--quiet", options.quiet, "no progress, no message");
}

}  // namespace capcon::cli
