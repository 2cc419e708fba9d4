#pragma once

#include <string>

#include "study/figures.h"
#include "study/html.h"

namespace capcon {

/// Every cell's figures with their intervals: sampler by sampler, by rising counts.
Csv cells_csv(const Figures& figures);
/// Every comparison with `baseline`.
Csv ratios_csv(const Figures& figures, const std::string& baseline);

}  // namespace capcon
