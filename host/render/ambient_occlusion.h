#pragma once

#include <functional>

#include "render/renderer_state.h"
#include "scene/job.h"

namespace capcon {

/// Ambient occlusion on the device: a primary ray a pixel (or one a sample where samples are jittered), then
/// one occlusion ray a sample, in batches of a fraction of a second. Only these rows of the image.
RenderResult render_ambient_occlusion(RendererState& state, const AmbientOcclusionJob& job, int first_row,
                                      int rows, const std::function<void(double)>& on_progress);

/// The specialisations of its kernels, to be compiled while the tree is built.
std::vector<KernelVariant> ambient_occlusion_kernels(const RendererState& state,
                                                     const AmbientOcclusionJob& job);

}  // namespace capcon
