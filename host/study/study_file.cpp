#include "study/study_file.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.h"
#include "base/file.h"
#include "study/json_numbers.h"
#include "study/merge.h"
#include "study/run_record.h"

namespace capcon {
using nlohmann::json;

namespace {

Cost cost_from(const json& c) {
  return {c.at("read_seconds").get<double>(),     c.at("build_seconds").get<double>(),
          c.at("upload_seconds").get<double>(),   c.at("compile_seconds").get<double>(),
          c.at("device_seconds").get<double>(),   whole<std::uint64_t>(c, "scene_bytes"),
          whole<std::uint64_t>(c, "device_bytes")};
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
  result.repeats = whole<int>(e, "repeats");
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

}  // namespace

StudyFile read_study_file(const std::filesystem::path& file) {
  StudyFile kept;
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
  return kept;
}

}  // namespace capcon
