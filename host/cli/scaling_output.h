#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/scaling_bench.h"

namespace capcon::cli {

nlohmann::json scaling_json(const std::vector<ScalingPoint>& points);
void print_scaling(const std::vector<ScalingPoint>& points);
/// Cost against size, primary and occlusion rays side by side, as an SVG or PNG picture.
void draw_scaling(const std::vector<ScalingPoint>& points, const std::string& path);

}  // namespace capcon::cli
