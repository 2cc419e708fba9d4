#pragma once

#include <string>
#include <vector>

#include "study/figures.h"

namespace capcon {

/// What a study of instant global illumination says, most important first: errors beside the baselines' set
/// count by set count, whatever they are; then what of the error is structure, and whether the mean over
/// seeds shows a bias.
std::vector<std::string> make_igi_findings(const StudySettings& settings, const Figures& figures);

}  // namespace capcon
