#include "study/kept_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "study/merge.h"
#include "study/report.h"
#include "study/study_file.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// The runs of the study, in its plan's order, of all that were ever measured in the folder.
std::vector<RunRecord> records_of(const StudySettings& settings, const RunFile& runs,
                                  const fs::path& folder) {
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, const RunRecord*> found;
  for (const RunRecord& r : runs.records) found[{r.run.sampler, r.run.samples, r.run.seed}] = &r;
  std::vector<RunRecord> records;
  // Counted before it is written out: a broken file may plan more than there is room for.
  const std::uint64_t planned =
      std::uint64_t(settings.samplers.size()) * settings.samples.size() * settings.seeds;
  std::uint64_t missing = planned > found.size() ? planned - found.size() : 0;
  if (missing == 0) {
    for (const PlannedRun& run : plan_runs(settings)) {
      const auto it = found.find({run.sampler, run.samples, run.seed});
      if (it == found.end()) {
        ++missing;
      } else {
        records.push_back(*it->second);
      }
    }
  }
  if (missing > 0) {
    throw InputError(
        fmt::format("{}: {} of the runs of study.json are missing there; give the study's command again",
                    (folder / "runs.jsonl").string(), missing));
  }
  return records;
}

}  // namespace

KeptStudy read_kept_study(const fs::path& folder) {
  const fs::path file = folder / "study.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw InputError(
        fmt::format("{}: there is no study.json; name the folder that a finished study was given with -o",
                    folder.string()));
  }
  StudyFile study = read_study_file(file);
  KeptStudy kept{folder, {}, std::move(study.result), std::move(study.explanation)};
  StudyResult& result = kept.result;
  if (!fs::exists(folder / "runs.jsonl", ignored)) {
    throw InputError(fmt::format(
        "{}: runs.jsonl is not there, which holds every run; copy it beside study.json", folder.string()));
  }
  const RunFile runs = read_runs(folder / "runs.jsonl");
  if (runs.header.is_object()) kept.hash = runs.header.value("settings_hash", "");
  result.records = records_of(result.settings, runs, folder);
  if (auto reference = read_reference(folder / "reference.exr", kept.hash))
    result.reference.image = reference->image;
  return kept;
}

Figures make_figures(const KeptStudy& study) {
  Figures figures = make_figures(study.result);
  std::error_code ignored;
  if (keeps_images(study.result.settings.integral) && !study.result.reference.image.pixels.empty() &&
      fs::is_directory(study.folder / "images", ignored))
    figures.noise = make_noise(study.result, run_images(study.folder, study.hash));
  return figures;
}

std::string html_report(const KeptStudy& study, const Figures& figures) {
  return html_report(study.result, figures, read_close_ups(study.folder / kCloseUpFolder, study.hash),
                     study.explanation);
}

}  // namespace capcon
