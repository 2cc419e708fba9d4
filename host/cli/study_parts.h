#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "distributed/ranks.h"
#include "study/regression.h"
#include "study/study.h"

namespace capcon::cli {

/// What part of a study is done here, and what it is held against.
struct StudyParts {
  std::string shard;            ///< "2/4"; empty: all of it
  bool only_reference = false;  ///< make what all shards measure against, and end
  std::string baseline;         ///< a study.json of before; empty: none

  void add_to(CLI::App& study);
  /// InputError for what does not go together.
  void check(const Ranks& ranks) const;
  /// Whether a part is all that is wanted here.
  bool is_part() const { return !shard.empty() || only_reference; }
};

/// Does that part, and says where it is and what comes next.
void run_part(const StudyParts& parts, const StudySettings& settings, const MakeStudyDevice& make_device,
              const RunnerOptions& options, const Ranks& ranks);

/// Holds a study against the baseline, if there is one: puts "check" into its JSON and hands back the lines
/// to print.
std::string hold_against(const std::optional<Baseline>& baseline, nlohmann::json& study);
/// Failure where figures worsened. An empty study is judged elsewhere.
void judge(const std::optional<Baseline>& baseline, const nlohmann::json& study);

}  // namespace capcon::cli
