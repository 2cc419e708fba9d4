#pragma once

#include <string>
#include <vector>

#include "integrate/analysis.h"

namespace capcon::integrate {

/// What `capcon integrate` prints: a table an integrand, then the findings.
std::string text_tables(const Experiment& experiment, const Analysis& analysis,
                        const std::vector<std::string>& findings);

}  // namespace capcon::integrate
