#pragma once

#include <string>
#include <vector>

#include "integrate/analysis.h"
#include "integrate/energy_plane.h"

namespace capcon::integrate {

/// What the figures say, in sentences; the first is the headline. Nothing is said that was not measured.
std::vector<std::string> make_findings(const Experiment& experiment, const Analysis& analysis,
                                       const std::vector<GeneratorEnergy>& plane);

}  // namespace capcon::integrate
