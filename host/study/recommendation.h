#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/statistics.h"

namespace capcon {

struct Column;
struct Figures;
struct StudySettings;

/// Which sampler to use for a study's scene, and how sure that is.
struct Recommendation {
  std::string sampler;        ///< the one that errs least
  std::string baseline;       ///< whose render the budget is: sobol-owen, else sobol-xor, else the first
  std::uint32_t samples = 0;  ///< of that render
  bool by_time = false;       ///< in the device time that it takes; else with as many samples
  Interval error;             ///< MSE of `sampler` / that of `baseline`, within the budget
  std::size_t compared = 0;   ///< samplers that have a figure within the budget
  std::vector<std::string> undecided;  ///< the others of them that are not shown (95 %) to err more
  /// Those of them that are not with as many samples either: errors alone are surer than errors in a time.
  std::vector<std::string> undecided_by_samples;
};

/// None where nothing sure was measured at the budget, or there is one sampler alone. The budget is 64
/// samples where they were measured, else the most, or fewer where more samplers have a figure then; of light
/// paths and splits the middle count.
std::optional<Recommendation> recommend(const StudySettings& settings,
                                        const std::map<std::string, std::vector<Column>>& columns,
                                        bool times_comparable);

/// The first sentence of a report.
std::string sentence(const Recommendation& r, const StudySettings& settings, const Figures& figures);

/// 64 samples where they were measured, else the most; of light paths and splits the middle count.
std::uint32_t spoken_count(const StudySettings& settings);

nlohmann::json to_json(const Recommendation& r);

}  // namespace capcon
