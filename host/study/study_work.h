#pragma once

#include "base/progress.h"
#include "base/stop.h"
#include "study/runner.h"

namespace capcon {

/// The header of a study's runs.jsonl.
nlohmann::json study_header(const StudySettings& settings, const nlohmann::json& device,
                            const std::string& hash);

/// A study, or a shard of one, under way: what it renders, measures and keeps, in words that say how far it
/// is.
class StudyWork {
 public:
  /// `plan`: what is to be measured here; finished runs of `log` count as done. Without a plan there need be
  /// no log.
  StudyWork(const StudySettings& settings, const StudyDevice& device, const RunnerOptions& options,
            RunLog* log, std::vector<PlannedRun> plan);
  StudyWork(const StudyWork&) = delete;
  StudyWork& operator=(const StudyWork&) = delete;

  /// Renders one group of the reference.
  Image reference_group(std::uint32_t group);
  /// Or none had to be rendered: for the progress bar.
  void reference_was_there();
  /// Measures what is missing, against result.reference, and puts all records of the plan into the result, in
  /// its order. New ones bear the process and calibration of `by`.
  void measure_all(StudyResult& result, const RunImages* images, const RunRecord& by = {});
  /// Device seconds of one and the same job in every process of a study: the reference's sampler at the
  /// middle count, the median of five renders after one that does not count.
  double calibration_seconds();

 private:
  double total() const;
  std::string kept() const;
  void step(std::uint32_t samples, const std::string& note);

  const StudySettings& settings_;
  const RunnerOptions& options_;
  RunLog* log_;
  std::vector<PlannedRun> plan_;
  RenderJob render_;
  std::size_t done_runs_;
  double done_ = 0;
  Progress progress_;
  StopMessage stop_;
};

}  // namespace capcon
