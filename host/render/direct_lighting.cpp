#include "render/direct_lighting.h"

#include <cassert>

#include "base/error.h"
#include "render/direct_pass.h"

namespace capcon {

void check_direct_job(const DirectLightingJob& job) {
  if (job.image_samples == 0 || job.integrator_samples == 0)
    throw InputError("the number of samples must be at least 1");
  if (std::uint64_t(job.image_samples) * job.integrator_samples > (1u << 24))
    throw InputError("more than 2^24 samples a pixel are too many for one image; average several seeds");
}

RenderResult render_direct_lighting(RendererState& state, const DirectLightingJob& job, int first_row,
                                    int rows, const std::function<void(double)>& on_progress) {
  check_direct_job(job);
  assert(first_row >= 0 && rows > 0 && first_row + rows <= state.film.height);
  if (!state.features.shading) throw Failure("this renderer was made for ambient occlusion alone");
  return DirectLightingPass(state, job, first_row, rows, on_progress).run();
}

std::vector<KernelVariant> direct_lighting_kernels(const RendererState& state, const DirectLightingJob& job) {
  const bool jittered = job.position == PixelPosition::jittered;
  const auto sampler = integrator_sampler(job, state.film);
  const std::uint32_t id = sampler->tables({}).id;
  const bool ordered = !order_of(job, *sampler).empty();
  // Places in the pixel are points of sets in one part.
  const std::uint32_t image_id = id & ~layout::kSamplerInParts;
  std::vector<KernelVariant> variants = {state.primary_variant(jittered, image_id, job.filter)};
  const DirectVariants direct = direct_variants(state, job, id, ordered, false);
  variants.insert(variants.end(), direct.lights.begin(), direct.lights.end());
  variants.insert(variants.end(), direct.bsdf.begin(), direct.bsdf.end());
  variants.push_back({"resolve", {}});
  variants.push_back({"emission", {}});
  return variants;
}

}  // namespace capcon
