#pragma once

#include <string>
#include <vector>

#include "stability/check.h"

namespace capcon::stability {

/// One HTML file that loads nothing else: verdict, a table a group with every bound and its reason, and what
/// ran.
std::string stability_page(const std::vector<Check>& checks, const std::string& command);

}  // namespace capcon::stability
