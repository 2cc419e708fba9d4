#pragma once

#include <glm/vec4.hpp>
#include <vector>

namespace capcon {

/// Quantiles of the Gaussian filter, exp(-2 t^2) - exp(-4.5) on [-1.5, 1.5] (pbrt-v4's, standard deviation
/// 0.5 pixels), for shaders/sampling/filter.glsl: for each of layout::kFilterIntervals equal parts of
/// probability the first value and the step to the next, as float bits in a texel. Linear between them,
/// within 1e-5 pixels but for the outermost thousandths.
std::vector<glm::uvec4> gaussian_filter_table();

}  // namespace capcon
