#pragma once

#include <functional>

#include "render/renderer_state.h"
#include "scene/job.h"

namespace capcon {

/// Direct lighting on the device (docs/direct.md): primary rays, then for each light a shadow ray a sample
/// and for all of them a ray a sample of the BSDF, summed pixel by pixel in the order of the samples. Only
/// these rows of the image.
RenderResult render_direct_lighting(RendererState& state, const DirectLightingJob& job, int first_row,
                                    int rows, const std::function<void(double)>& on_progress);

/// InputError where its numbers make no sense.
void check_direct_job(const DirectLightingJob& job);

/// The specialisations of its kernels, to be compiled while the tree is built.
std::vector<KernelVariant> direct_lighting_kernels(const RendererState& state, const DirectLightingJob& job);

}  // namespace capcon
