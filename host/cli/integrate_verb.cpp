#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "cli/verbs.h"
#include "integrate/analysis.h"
#include "integrate/experiment.h"
#include "integrate/integrand.h"
#include "integrate/report.h"
#include "integrate/text_table.h"
#include "study/plan.h"

namespace capcon::cli {
namespace {

struct Options {
  integrate::Settings settings;
  std::string counts = "4..4096";
  std::string directory;
  bool json = false;
};

std::string names_of(const auto& list) {
  std::string names;
  for (const auto& item : list) names += (names.empty() ? "" : " ") + item.name;
  return names;
}

void run(Options& o) {
  namespace fs = std::filesystem;
  o.settings.counts = parse_samples(o.counts);
  if (!o.directory.empty()) {  // told before the work
    create_folder(o.directory);
    check_writable(fs::path(o.directory) / "report.html");
  }
  const integrate::Report report = integrate::make_report(o.settings);
  if (!o.directory.empty()) {
    write_file(fs::path(o.directory) / "results.json", report.json.dump(1) + "\n");
    write_file(fs::path(o.directory) / "report.html", report.page);
  }
  if (o.json) {
    fmt::print("{}\n", report.json.dump(2));
  } else {
    fmt::print("{}", report.text);
  }
  if (!o.directory.empty() && !o.settings.quiet) {
    fmt::print(stderr, "The report is {}\n",
               fs::absolute(fs::path(o.directory) / "report.html").lexically_normal().string());
  }
}

}  // namespace

void add_integrate_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "integrate",
      "error of every point set on integrals that are known, beside the theory's bounds\n\n"
      "  capcon integrate -o report/integrate            all, in about a minute\n"
      "  capcon integrate --integrands disk,smooth --estimators random,sobol-owen,capcon -n 16..256\n");
  auto o = std::make_shared<Options>();
  integrate::Settings& s = o->settings;
  verb->add_option("--integrands", s.integrands,
                   "any of: " + names_of(integrate::battery()) + " (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  verb->add_option("--estimators", s.estimators,
                   "any of: " + names_of(integrate::estimators()) + " (default: all); or file:PATH")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  verb->add_option("-n", o->counts, "numbers of points: counts and doubling ranges")->capture_default_str();
  verb->add_option("--randomisations", s.randomisations, "trials behind each error")
      ->check(CLI::Range(2u, 1000000u))
      ->capture_default_str();
  verb->add_option("--seed", s.seed, "of all random numbers")->capture_default_str();
  verb->add_option("-o,--output", o->directory, "folder for report.html and results.json");
  verb->add_flag("--json", o->json, "print results.json instead of tables");
  verb->add_flag("--quiet", s.quiet, "no progress and no messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
