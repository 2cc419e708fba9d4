#include "study/study.h"

#include <fmt/format.h>

#include "base/file.h"
#include "base/stop.h"
#include "study/report.h"

namespace capcon {
namespace fs = std::filesystem;

StudyReport study_report(const StudySettings& settings, const MakeStudyDevice& make_device,
                         const RunnerOptions& options, const std::optional<Explanation>& explanation) {
  return make_report(run_study(settings, make_device(settings.width, settings.height), options), make_device,
                     options, explanation);
}

StudyReport make_report(StudyResult result, const MakeStudyDevice& make_device, const RunnerOptions& options,
                        const std::optional<Explanation>& explanation) {
  StudyReport report;
  report.result = std::move(result);
  const StudySettings& settings = report.result.settings;
  const StopMessage stop(fmt::format("all runs are kept in {}, and the same command makes the report",
                                     options.directory.string()));
  report.figures = make_figures(report.result);
  if (keeps_images(settings.integral)) {
    const std::string hash = settings_hash(settings, report.result.device);
    report.figures.noise = make_noise(report.result, run_images(options.directory, hash));
  }
  report.json = to_json(report.result, report.figures);
  if (explanation) report.json["explanation"] = to_json(*explanation);
  write_file(options.directory / "study.json", report.json.dump(2) + "\n");
  std::optional<CloseUps> close_ups;
  const fs::path folder = options.directory / kCloseUpFolder;
  if (settings.close_ups && make_device) {
    close_ups = make_close_ups(settings, make_device, options);
    write_close_ups(folder, *close_ups, settings_hash(settings, report.result.device));
  } else if (!make_device) {
    close_ups = read_close_ups(folder, settings_hash(settings, report.result.device));
  }
  report.page = options.directory / "report.html";
  write_file(report.page, html_report(report.result, report.figures, close_ups, explanation));
  return report;
}

}  // namespace capcon
