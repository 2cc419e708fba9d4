#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "layout.h"
#include "render/batches.h"
#include "render/device_context.h"
#include "render/dispatch.h"
#include "render/features.h"
#include "render/placement.h"
#include "render/ray_queue.h"
#include "render/renderer.h"
#include "render/shading_data.h"
#include "render/view.h"
#include "sampling/sampler.h"
#include "shading/scene_bounds.h"

namespace capcon {

/// A kernel and what a job's way of using it fixes; the scene's own constants are added to these.
struct KernelVariant {
  std::string name;
  Constants constants;
};

/// Lights of a scene on the device.
struct DeviceLights {
  std::vector<std::uint32_t> kinds;  ///< kLight... of each
  std::uint32_t area_lights = 0;     ///< they come first
};

/// A scene on a device: what every integrator's passes share.
struct RendererState {
  std::unique_ptr<DeviceContext> context;
  const gpu::DeviceDescription& description;
  gpu::Device& device;
  Kernels& kernels;
  Features features;
  Film film;
  Placement placement;
  View view;  ///< in the device's space, as all that follows
  layout::TreeConstants tree{};
  Constants scene_constants;
  std::uint64_t triangle_count = 0, quadric_count = 0, instance_count = 0, node_count = 0;
  std::size_t band_pixels = 0;             ///< pixels that surfaces and counts are kept for at a time
  std::uint64_t most_lanes = kBatchLanes;  ///< of a dispatch
  std::uint64_t fixed_lanes = 0;           ///< RendererOptions::batch_lanes
  gpu::Buffer nodes, primitives, quadrics, instances, details, surfaces, shading, counts, sampler_table,
      image_table, order, materials, textures, lights, environments, samples, sums, filter;
  /// Of instant global illumination; made when they are first needed. Receivers are surfaces that
  /// compensation rays met.
  gpu::Buffer gather_table, virtual_lights, paths, path_hits, found, receivers, receiver_shading,
      receiver_sums;
  RayQueue ray_queue;
  DeviceLights light_list;             ///< empty without Features::shading
  std::vector<std::string> warnings;   ///< of materials and lights
  BoundingSphere bounds;               ///< of the scene
  double geometry_limit = 1;           ///< default_geometry_limit()
  std::uint32_t default_material = 0;  ///< of shapes without one
  Timings setup;

  /// `first`: the job that will be rendered first, if it is known; its kernels are compiled while the tree is
  /// built.
  RendererState(const Scene& scene, const RendererOptions& options, std::unique_ptr<DeviceContext> opened,
                const Job* first);

  /// Binds what a kernel names of the scene's buffers.
  void bind_all(gpu::Kernel& kernel) const { bind_all(kernel, {}); }
  /// Puts a sampler's table, and the order in which its points are taken (empty: as they are), where kernels
  /// read it.
  void set_sampler(const SamplerTables& tables, const std::vector<glm::uvec4>& sample_order = {});
  /// The table of the sampler that places image samples, which the primary kernel reads.
  void set_image_sampler(const SamplerTables& tables);
  /// The table of the sampler that compensation rays have.
  void set_gather_sampler(const SamplerTables& tables);
  /// Room for so many light paths, and for what a batch of compensation rays finds. What there is room for
  /// stays.
  void need_paths(std::size_t paths, std::size_t compensation_rays);
  /// Puts texels where kernels read them; the buffer grows as needed.
  void put(gpu::Buffer& buffer, const std::vector<glm::uvec4>& texels) { grow(buffer, texels); }
  /// What a batch of direct lighting writes to; made when it is first needed.
  void need_samples();
  /// Sizes of a job's dispatches.
  Batches batches() const { return Batches(most_lanes, fixed_lanes); }
  /// Halves what is worked on at a time, for a device that has no room for it. False: it is little already.
  bool shrink();
  /// The variant's constants and the scene's.
  Constants constants(const KernelVariant& variant) const;
  gpu::Kernel& kernel(const KernelVariant& variant);
  /// The primary kernel for image samples of this sampler, or at pixel centres.
  KernelVariant primary_variant(bool jittered, std::uint32_t sampler_id, PixelFilter filter) const;
  /// Bytes of each buffer that holds something of the scene.
  std::map<std::string, std::size_t> buffer_bytes() const;

 private:
  void compile_for(const Job& job);
  void grow(gpu::Buffer& buffer, const std::vector<glm::uvec4>& texels);
  void upload(const struct Geometry& geometry);
  void make_band();
  void upload_shading(const ShadingData& data, bool everything);
  void bind_all(gpu::Kernel& kernel, const KernelVariant& variant) const;
  void bind_again() const;

  struct Bound {
    gpu::Kernel* kernel;
    KernelVariant variant;
  };
  std::vector<Bound> bound_;  ///< all kernels there are: bound again when a buffer moves
};

/// Pixels of a band: what a pixel needs on the device while it is rendered stays below 128 MiB, the least
/// that a storage buffer can bind, however large the image is.
constexpr std::size_t kBandPixels = std::size_t(1) << 21;

}  // namespace capcon
