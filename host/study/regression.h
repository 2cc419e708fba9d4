#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/statistics.h"

namespace capcon {

/// A study.json of before, that a study is held against (docs/ci.md).
struct Baseline {
  std::filesystem::path file;
  nlohmann::json json;
};

/// InputError where it is not what a study wrote.
Baseline read_baseline(const std::filesystem::path& file);

/// InputError where the baseline is of another scene or other settings, or has samplers that the study does
/// not measure: one sentence names the first difference. What the samplers make, the device and the version
/// may differ: they are what is checked. `settings`: to_json(StudySettings).
void check_comparable(const Baseline& baseline, const nlohmann::json& settings);

/// A figure that worsened.
struct Worsening {
  std::string sampler, baseline;
  std::uint32_t samples = 0;
  std::string was, is;  ///< "57.0 (56.0–58.0)", "> 256"
  double factor = 1;    ///< how much more it is, at least
  bool by_mse = false;  ///< the figure is a ratio of MSE, at equal samples
};

/// Every figure of the baseline beside that of the study.
struct Regression {
  std::vector<Worsening> worse;  ///< in the study's order
  std::size_t compared = 0;
  std::size_t skipped = 0;  ///< without an interval, then or now
};

/// Compares the figures of equal error beside sobol-xor and sobol-owen; the ratios of MSE at equal samples
/// where more samples were needed then than were measured, and in a study of splitting, where all counts are
/// the same work. A figure x worsened where the 95 % interval of log(x now / x then) lies above 0; its half
/// width is sqrt(h_now^2 + h_then^2) of the two figures' own, in logarithms: both were measured
/// independently, and Student's t of either's seeds is no smaller than that of the difference. A figure that
/// is beyond what was measured counts as the end that it is beyond of. `study`: a study.json.
Regression find_regressions(const Baseline& baseline, const nlohmann::json& study);

/// One sentence for people.
std::string sentence(const Worsening& worsening, const nlohmann::json& study);
/// As the "check" of a study.json.
nlohmann::json to_json(const Regression& regression, const Baseline& baseline);

}  // namespace capcon
