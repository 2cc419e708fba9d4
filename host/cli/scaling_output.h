#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/scaling_bench.h"

namespace capcon::cli {

nlohmann::json scaling_json(const std::vector<ScalingSeries>& series);
void print_scaling(const std::vector<ScalingSeries>& series);
/// Cost against size, primary and occlusion rays side by side, a row for each series, as an SVG or PNG
/// picture.
void draw_scaling(const std::vector<ScalingSeries>& series, const std::string& path);

}  // namespace capcon::cli
