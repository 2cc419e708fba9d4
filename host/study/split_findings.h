#pragma once

#include <string>
#include <vector>

#include "study/figures.h"

namespace capcon {

/// How a variant's error moves over the splits of a study of splitting.
struct Flatness {
  std::string variant;
  double mean = 0;       ///< of the MSE over the splits
  double farthest = 0;   ///< largest |MSE / mean - 1|
  std::uint32_t at = 0;  ///< image samples of that split
};
/// Of the variants whose cells are all sure.
std::vector<Flatness> flatness(const Figures& figures);

/// What a study of splitting says, most important first.
std::vector<std::string> make_split_findings(const StudySettings& settings, const Figures& figures);

}  // namespace capcon
