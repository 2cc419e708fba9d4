#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/instance.h"
#include "layout.h"
#include "render/kernels.h"
#include "render/renderer.h"
#include "render/view.h"
#include "sampling/sampler.h"

namespace capcon {

/// A scene on a device: what every integrator's passes share.
struct RendererState {
  gpu::Instance instance;
  gpu::DeviceDescription description;
  gpu::Device device;
  bool texel_fetch;
  Kernels kernels;
  Film film;
  View view;
  layout::TreeConstants tree{};
  std::map<std::uint32_t, std::uint32_t> scene_constants;
  std::uint64_t triangle_count = 0, quadric_count = 0, node_count = 0;
  gpu::Buffer nodes, primitives, quadrics, surfaces, counts, sampler_table;
  Timings setup;

  RendererState(const Scene& scene, const RendererOptions& options);

  /// Binds what a kernel names of the scene's buffers.
  void bind_all(gpu::Kernel& kernel) const;
  /// Puts a sampler's table where kernels read it.
  void set_sampler(const SamplerTables& tables);
  /// A kernel for this scene and sampler; `jittered` as kSpecJittered.
  gpu::Kernel& kernel(const std::string& name, std::uint32_t sampler_id, bool jittered);

 private:
  std::vector<gpu::Kernel*> bound_;  ///< all kernels there are: bound again when the sampler's table moves
};

}  // namespace capcon
