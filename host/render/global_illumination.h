#pragma once

#include <functional>

#include "render/renderer_state.h"
#include "scene/job.h"

namespace capcon {

/// Instant global illumination on the device (docs/igi.md): light paths, then for each pixel direct light, a
/// ray to every virtual light of its sets, and short rays for what clamping leaves out, with the same at the
/// surfaces that those meet. Only these rows of the image. InputError as check_job() and trace_light_paths().
RenderResult render_global_illumination(RendererState& state, const GlobalIlluminationJob& job, int first_row,
                                        int rows, const std::function<void(double)>& on_progress);

/// The specialisations of its kernels, to be compiled while the tree is built.
std::vector<KernelVariant> global_illumination_kernels(const RendererState& state,
                                                       const GlobalIlluminationJob& job);

}  // namespace capcon
