#pragma once

#include <string>
#include <vector>

#include "study/figures.h"

namespace capcon {

/// The sampler a study is about: capcon-domain where it was measured (of light paths: capcon), else capcon,
/// else the last of the list that is no baseline.
std::string study_subject(const StudySettings& settings);

/// What the figures say, in plain sentences made from them: the headline first. Whatever they say; a
/// difference is only called one where its 95 % interval shows it.
std::vector<std::string> make_findings(const StudySettings& settings, const Figures& figures);

}  // namespace capcon
