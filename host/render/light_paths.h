#pragma once

#include "render/renderer_state.h"
#include "scene/job.h"
#include "shading/virtual_light.h"

namespace capcon {

/// VPLs as kernels read them (shaders/gather.comp).
struct DeviceVirtualLights {
  /// Five each: position and primitive; normal and material; flux; shading normal and u; arriving direction
  /// and v. Set by set, in each by bounce, then by path.
  std::vector<glm::uvec4> texels;
  std::vector<std::uint32_t> first = {0};  ///< of each set, and the end
  std::vector<glm::uvec2> path_and_bounce;
  std::uint64_t rays = 0;  ///< that paths took
  std::uint32_t count(std::uint32_t set) const { return first[set + 1] - first[set]; }
};

/// The seed of light paths, docs/igi.md.
constexpr std::uint32_t path_seed(std::uint32_t seed) {
  return seed ^ 0x70617468u;
}

/// The sampler of a job's light paths.
std::unique_ptr<Sampler> path_sampler(const GlobalIlluminationJob& job);

/// Traces a job's light paths, one bounce of all of them after another. Uses the sampler's buffer. InputError
/// where no light emits or no path hits anything; Failure where the VPLs are more than a buffer can bind.
/// Adds to `timings` (points, light paths).
DeviceVirtualLights trace_light_paths(RendererState& state, const GlobalIlluminationJob& job,
                                      Timings& timings);

/// The kernels that it uses.
std::vector<KernelVariant> light_path_kernels(std::uint32_t sampler_id);

/// As plain values.
VirtualLights unpack(const DeviceVirtualLights& lights, const Placement& placement,
                     std::uint32_t default_material);

}  // namespace capcon
