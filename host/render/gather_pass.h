#pragma once

#include "render/direct_pass.h"
#include "render/light_paths.h"

namespace capcon {

/// Rays from surfaces to virtual lights.
struct GatherWork {
  std::uint32_t first_pixel = 0, pixel_count = 0;  ///< pixels, or receivers
  std::uint32_t band = 0;
  std::uint32_t first_set = 0;  ///< of the pixel at block (0, 0); the others' follow
  std::uint32_t block = 1, width = 1;
  float limit = 3e38f;
};

/// A job of direct lighting that has virtual lights, too.
class GatherPass : public DirectLightingPass {
 protected:
  using DirectLightingPass::DirectLightingPass;

  /// Adds what virtual lights bring to the sums of these pixels, or (`sum` another kernel than theirs)
  /// receivers.
  void gather(gpu::Kernel& kernel, gpu::Kernel& sum, GatherWork work, bool two_sided, float weight);

  DeviceVirtualLights lights_;
  std::uint64_t rays_ = 0;  ///< cast so far
  double all_work_ = 1;     ///< rays from pixels to virtual lights in all, for progress
};

}  // namespace capcon
