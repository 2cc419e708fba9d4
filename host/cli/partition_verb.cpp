#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/verbs.h"
#include "points/measure.h"
#include "points/partition.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string input, output;
  PartitionOptions partition;
  bool json = false;
};

void run(const Options& o) {
  if (!o.output.empty()) check_writable(o.output);
  const std::vector<Points> sets = read_points(o.input);
  if (sets.size() != 1)
    throw InputError(fmt::format("{}: holds {} sets; give a file with one", o.input, sets.size()));
  const auto subsets = split(sets[0], partition(sets[0], o.partition), o.partition.subsets);
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
    fmt::print("{}\n", nlohmann::ordered_json{{"input", o.input},
                                      {"n", sets[0].size()},
                                      {"subsets", o.partition.subsets},
                                      {"seed", o.partition.seed},
                                      {"delta_mean", mean},
                                      {"delta_mean_worst", worst},
                                      {"sets", measures}}
                           .dump(2));
  } else if (o.output.empty()) {
    fmt::print("{}", format_points(subsets));
  } else {
    fmt::print(stderr, "{}: {} points in {} subsets, delta_mean {:.3f}, worst {:.3f}\n", o.output,
               sets[0].size(), subsets.size(), mean, worst);
  }
}

}  // namespace

void add_partition_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("partition", "Cut a point set into subsets that are each well spread");
  auto o = std::make_shared<Options>();
  verb->footer(
      "The subsets are written one after another, '#' between them; their union is the input.\n"
      "Example: capcon points ccvt -n 1024 -o p.txt && capcon partition p.txt -k 8 -o parts.txt");
  verb->add_option("file", o->input, "Point set: one \"x y\" a line")->required();
  verb->add_option("-k,--subsets", o->partition.subsets, "How many subsets")->capture_default_str();
  verb->add_option("--seed", o->partition.seed, "Seed of the labels it starts from")->capture_default_str();
  verb->add_option("-o,--output", o->output, "File to write; default: standard output");
  verb->add_flag("--json", o->json, "Measures of each subset as JSON on stdout, instead of points");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
