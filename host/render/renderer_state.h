#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "gpu/buffer.h"
#include "layout.h"
#include "render/device_context.h"
#include "render/features.h"
#include "render/renderer.h"
#include "render/view.h"
#include "sampling/sampler.h"

namespace capcon {

/// A scene on a device: what every integrator's passes share.
struct RendererState {
  std::unique_ptr<DeviceContext> context;
  const gpu::DeviceDescription& description;
  gpu::Device& device;
  Kernels& kernels;
  Features features;
  Film film;
  View view;
  layout::TreeConstants tree{};
  Constants scene_constants;
  std::uint64_t triangle_count = 0, quadric_count = 0, instance_count = 0, node_count = 0;
  std::size_t band_pixels = 0;  ///< pixels that surfaces and counts are kept for at a time
  gpu::Buffer nodes, primitives, quadrics, instances, details, images, surfaces, shading, counts,
      sampler_table, order;
  Timings setup;

  /// `first`: the job that will be rendered first, if it is known; its kernels are compiled while the tree is
  /// built.
  RendererState(const Scene& scene, const RendererOptions& options, std::unique_ptr<DeviceContext> opened,
                const AmbientOcclusionJob* first);

  /// Binds what a kernel names of the scene's buffers.
  void bind_all(gpu::Kernel& kernel) const;
  /// Puts a sampler's table, and the order in which its points are taken (empty: as they are), where kernels
  /// read it.
  void set_sampler(const SamplerTables& tables, const std::vector<glm::uvec4>& sample_order = {});
  /// The specialisation of a kernel for this scene and sampler; `jittered` concerns "primary", `ordered`
  /// "occlusion".
  Constants constants(std::uint32_t sampler_id, bool jittered, bool ordered) const;
  gpu::Kernel& kernel(const std::string& name, std::uint32_t sampler_id, bool jittered, bool ordered = false);
  /// Bytes of each buffer that holds something of the scene.
  std::map<std::string, std::size_t> buffer_bytes() const;

 private:
  void compile_for(const AmbientOcclusionJob& job);
  void grow(gpu::Buffer& buffer, std::uint32_t binding, const std::vector<glm::uvec4>& texels);
  void upload(const Scene& scene, const struct Geometry& geometry);

  std::vector<gpu::Kernel*> bound_;  ///< all kernels there are: bound again when the sampler's table moves
};

/// Pixels of a band: what a pixel needs on the device while it is rendered stays below 128 MiB, the least
/// that a storage buffer can bind, however large the image is.
constexpr std::size_t kBandPixels = std::size_t(1) << 21;

}  // namespace capcon
