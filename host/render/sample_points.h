#pragma once

#include <vector>

#include "render/renderer_state.h"

namespace capcon {

/// Runs the sampler's shader side alone: the points of pixels 0 ... pixels - 1, sampler.count() each, as
/// bits.
std::vector<FixedPoint> read_sample_points(RendererState& state, const Sampler& sampler, std::uint32_t pixels,
                                           std::uint32_t dimension, SampleDomain domain);

}  // namespace capcon
