#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "render/explain.h"
#include "study/figures.h"
#include "study/runner.h"

namespace capcon {

struct StudyReport {
  StudyResult result;
  Figures figures;
  nlohmann::json json;         ///< as in study.json
  std::filesystem::path page;  ///< report.html
};

/// The whole study: measures or goes on, computes the figures, renders close-ups if the settings want them,
/// and writes study.json and report.html; both show `explanation` if there is one.
StudyReport study_report(const StudySettings& settings, const MakeStudyDevice& make_device,
                         const RunnerOptions& options, const std::optional<Explanation>& explanation = {});

/// The same from what was measured already. Without a device close-ups are those that were kept before, if
/// any.
StudyReport make_report(StudyResult result, const MakeStudyDevice& make_device, const RunnerOptions& options,
                        const std::optional<Explanation>& explanation = {});

}  // namespace capcon
