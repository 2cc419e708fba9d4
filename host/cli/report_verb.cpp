#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/verbs.h"
#include "study/findings.h"
#include "study/overlay.h"
#include "study/report.h"

namespace capcon::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> folders, labels, samplers;
  std::string output;
  bool json = false, quiet = false;
};

void finish(const Options& o, const fs::path& page, const std::string& html, const nlohmann::json& json,
            const std::vector<std::string>& findings) {
  write_file(page, html);
  if (o.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    for (const std::string& finding : findings) fmt::print("{}\n", finding);
  }
  if (!o.quiet) fmt::print(stderr, "The report is {}\n", fs::absolute(page).lexically_normal().string());
}

void run(const Options& o) {
  const bool one = o.folders.size() == 1;
  if (one && !o.labels.empty()) throw InputError("--label names one of several studies; there is one");
  if (one && !o.samplers.empty())
    throw InputError("--samplers chooses lines of several studies; there is one");
  if (!one && o.output.empty())
    throw InputError("name the page that several studies are laid over each other in with -o");
  const fs::path page = o.output.empty() ? fs::path(o.folders.front()) / "report.html" : fs::path(o.output);
  std::vector<KeptStudy> studies;
  for (const std::string& folder : o.folders) studies.push_back(read_kept_study(folder));
  check_writable(page);
  if (one) {
    const KeptStudy& study = studies.front();
    const Figures figures = make_figures(study);
    finish(o, page, html_report(study, figures), to_json(study.result, figures),
           make_findings(study.result.settings, figures));
  } else {
    const Overlay overlay = make_overlay(std::move(studies), o.labels, o.samplers);
    finish(o, page, html_report(overlay), to_json(overlay), make_findings(overlay));
  }
}

}  // namespace

void add_report_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("report", "the page of a finished study anew, or several laid over each other");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Examples:\n"
      "  capcon report report/direct                            its report.html anew, without a device\n"
      "  capcon report -o both.html laptop/direct node/direct   two machines, or two versions\n"
      "  capcon report -o both.html --label before,after --samplers capcon-domain,sobol-owen old new");
  verb->add_option("folders", o->folders, "what studies were given with -o")->required();
  verb->add_option("-o,--output", o->output, "the page (default, of one study: report.html in its folder)");
  verb->add_option("--label", o->labels,
                   "what to call each of several studies (default: names of the folders)")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--samplers", o->samplers,
                   "of several studies, only these (default: all that they have in common)")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_flag("--json", o->json, "print every figure as JSON instead of the findings");
  verb->add_flag("--quiet", o->quiet, "no messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
