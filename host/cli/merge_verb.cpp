#include <fmt/format.h>

#include "base/error.h"
#include "cli/study_parts.h"
#include "cli/verbs.h"
#include "study/merge.h"
#include "study/study_lock.h"
#include "study/table.h"

namespace capcon::cli {
namespace {

struct Options {
  std::vector<std::string> folders;
  std::string output, baseline;
  bool json = false, quiet = false;
};

void run(const Options& o) {
  std::optional<Baseline> baseline;
  if (!o.baseline.empty()) baseline = read_baseline(o.baseline);
  RunnerOptions options;
  options.directory = o.output.empty() ? o.folders.front() : o.output;
  options.quiet = o.quiet;
  if (o.output.empty() && o.folders.size() > 1)
    throw InputError("name the folder that the shards of several are merged into with -o");
  const StudyLock alone(options.directory);
  StudyResult merged = merge_shards(options.directory, {o.folders.begin(), o.folders.end()});
  if (baseline) check_comparable(*baseline, to_json(merged.settings));
  StudyReport report = make_report(std::move(merged), nullptr, options);
  const std::string lines = hold_against(baseline, report.json);
  if (o.json) {
    fmt::print("{}\n", report.json.dump(2));
  } else {
    fmt::print("{}{}", text_tables(report.result, report.figures), lines);
  }
  if (!o.quiet) {
    if (!report.result.moved.empty())
      fmt::print(stderr, "capcon: older runs with other settings are kept in {}\n",
                 report.result.moved.string());
    fmt::print(stderr, "The report, without close-ups, is {}\n",
               std::filesystem::absolute(report.page).lexically_normal().string());
  }
  judge(baseline, report.json);
}

}  // namespace

void add_merge_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("merge", "lay the shards of a study together: tables and report");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Examples:\n"
      "  capcon merge report/direct              its shards wrote to one folder\n"
      "  capcon merge -o all node1 node2 node3   each to its own");
  verb->add_option("folders", o->folders, "what the shards were given with -o")->required();
  verb->add_option("-o,--output", o->output,
                   "folder for report.html, runs.jsonl, study.json (default: the one)");
  verb->add_option(
      "--check", o->baseline,
      "study.json of before: exit code 1 where a figure of equal error worsened beyond its interval");
  verb->add_flag("--json", o->json, "print study.json instead of tables");
  verb->add_flag("--quiet", o->quiet, "no messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
