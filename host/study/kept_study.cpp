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

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

Cost cost_from(const json& c) {
  return {c.at("read_seconds").get<double>(),       c.at("build_seconds").get<double>(),
          c.at("upload_seconds").get<double>(),     c.at("compile_seconds").get<double>(),
          c.at("device_seconds").get<double>(),     c.at("scene_bytes").get<std::uint64_t>(),
          c.at("device_bytes").get<std::uint64_t>()};
}

Explanation explanation_from(const json& e) {
  Explanation result;
  for (const json& row : e.at("features")) {
    result.rows.push_back({row.at("name").get<std::string>(), row.at("in_scene").get<std::string>(),
                           row.at("used").get<bool>(), row.value("left_out", "")});
  }
  result.needed = cost_from(e.at("needed"));
  result.everything = cost_from(e.at("everything"));
  result.device_ratio = e.at("device_ratio").at("median").get<double>();
  result.device_ratio_low = e.at("device_ratio").at("low").get<double>();
  result.device_ratio_high = e.at("device_ratio").at("high").get<double>();
  result.repeats = e.at("repeats").get<int>();
  result.identical = e.at("identical").get<bool>();
  return result;
}

/// What the page takes for granted.
void check(const StudyResult& result) {
  const StudySettings& s = result.settings;
  for (const std::uint32_t n : s.samples) {
    if (n == 0 || (s.integral == Integral::splitting && (s.combined < n || s.combined % n != 0)))
      throw std::out_of_range("samples");
  }
  if (!result.device.is_object() || (result.device.contains("name") && !result.device["name"].is_string()))
    throw std::out_of_range("device");
  if (!(result.reference.error >= 0)) throw std::out_of_range("error");
}

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
  KeptStudy kept;
  kept.folder = folder;
  StudyResult& result = kept.result;
  const std::string text = read_file(file);
  try {
    const json study = parse_study_json(text);
    result.settings = settings_from_json(study.at("settings"));
    result.device = study.at("device");
    result.started = study.at("started").get<std::string>();
    result.version = study.at("version").get<std::string>();
    result.reference.error = study.at("reference").at("error").get<double>();
    result.reference.coarse_error = study.at("reference").value("coarse_error", 0.0);
    check(result);
    if (study.contains("explanation")) kept.explanation = explanation_from(study.at("explanation"));
  } catch (const std::exception&) {
    throw InputError(SourcePlace{file.string(), 0, 0},
                     "this is not a study.json as capcon study writes it; give the study's command again");
  }
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
