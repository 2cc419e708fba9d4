#include "render/renderer_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>

#include "base/error.h"
#include "gpu/check.h"
#include "render/ambient_occlusion.h"
#include "render/direct_lighting.h"
#include "render/filter_table.h"
#include "render/geometry.h"
#include "render/global_illumination.h"

namespace capcon {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The stack's array takes what its free registers do not hold. A few sizes rather than every one: scenes
/// share kernels in the driver's cache, and compiling can begin before the tree is there.
std::uint32_t stack_array(std::uint32_t entries) {
  constexpr std::uint32_t kRegisters = 7;
  std::uint32_t size = 16;
  while (size + kRegisters < entries) size *= 2;
  return size;
}

// What is worked on at a time when there is no room for more.
constexpr std::size_t kFewestPixels = 1 << 12;
constexpr std::uint64_t kFewestLanes = 1 << 14;

/// Whether kernels can read all these buffers by texel or storage bindings on this device.
bool fits(const gpu::DeviceDescription& device, std::size_t bytes, bool texels) {
  return texels ? bytes / 16 <= device.max_texels : bytes <= device.max_storage_bytes;
}

/// Refuses a scene whose triangles alone do not fit, before hours and gigabytes go into its tree.
void check_size(const Scene& scene, bool two_level, const gpu::DeviceDescription& device) {
  const std::uint64_t triangles = two_level ? scene.unique_triangles() : scene.instanced_triangles();
  const std::uint64_t bytes = 48 * triangles;
  if (bytes <= device.memory_bytes) return;
  throw Failure(
      fmt::format("{}: {} triangles need {:.1f} MiB and their tree as much again, and {} has {:.1f} MiB; {}",
                  scene.name, triangles, static_cast<double>(bytes) / (1 << 20), device.name,
                  static_cast<double>(device.memory_bytes) / (1 << 20),
                  two_level ? "try a smaller scene or another --device" : "try --instancing two-level"));
}

}  // namespace

RendererState::RendererState(const Scene& scene, const RendererOptions& options,
                             std::unique_ptr<DeviceContext> opened, const Job* first)
    : context(std::move(opened)),
      description(context->description),
      device(context->device),
      kernels(context->kernels),
      features(options.keep_everything ? all_features(scene, options.instancing)
                                       : needed_features(scene, first, options.instancing)),
      film(scene.film) {
  bounds = scene_bounds(scene);
  placement = place_scene(bounds, glm::dvec3(scene.camera.camera_to_world[3]));
  view = make_view(scene.camera, film.width, film.height, placement, bounds);
  bounds = {placement.to_device(bounds.centre), placement.scale * bounds.radius};
  features.shading = features.shading || options.shading;
  fixed_lanes = options.batch_lanes;
  scene_constants[layout::kSpecQuadrics] = features.quadrics ? 1 : 0;
  scene_constants[layout::kSpecInstances] = features.two_level ? 1 : 0;
  scene_constants[layout::kSpecDetails] = features.shading ? 1 : 0;
  scene_constants[layout::kSpecStackSize] = stack_array(0);
  const auto make_queue = [&] {
    ray_queue = RayQueue(device, kernels.texel_fetch(), kCpuBatchLanes, options.queue_iterations);
  };
  make_queue();
  setup.wall["device"] = context->open_seconds;
  check_size(scene, wants_two_levels(scene, options.instancing), description);
  auto start = Clock::now();
  DetailOptions details;
  if (features.shading) {
    const ShadingData data = make_shading_data(scene, options.keep_everything, placement);
    details = data.details;
    default_material = details.default_material;
    geometry_limit = default_geometry_limit(scene) / (placement.scale * placement.scale);
    upload_shading(data, options.keep_everything);
    setup.wall["shading"] = seconds_since(start);
    start = Clock::now();
  }
  std::future<void> compiling;
  if (first) compiling = std::async(std::launch::async, [&] { compile_for(*first); });
  // With everything kept the code of both levels is there, and the image stays the same: instances are
  // written out as before.
  Geometry geometry;
  try {
    const bool keep_instances = wants_two_levels(scene, options.instancing);
    geometry = build_geometry(scene, {.two_level = features.two_level,
                                      .keep_instances = keep_instances,
                                      .details = details,
                                      .placement = placement,
                                      .cut = wants_best_tree(scene, keep_instances, first, options.tree)});
  } catch (...) {
    if (compiling.valid()) compiling.wait();
    throw;
  }
  setup.wall["build"] = seconds_since(start);
  if (compiling.valid()) compiling.get();
  start = Clock::now();
  scene_constants[layout::kSpecStackSize] = stack_array(geometry.bvh.stack_entries);
  std::size_t largest = std::max(geometry.bvh.texels.size(), geometry.primitives.size()) * 16;
  for (const gpu::Buffer* buffer : {&materials, &textures, &lights, &environments})
    largest = std::max(largest, buffer->bytes());
  if (options.fetch == "auto" && !fits(description, largest, kernels.texel_fetch())) {
    kernels.set_texel_fetch(fits(description, largest, true));
    make_queue();
  }
  upload(geometry);
  setup.wall["upload"] = seconds_since(start);
}

void RendererState::upload(const Geometry& geometry) {
  triangle_count = geometry.triangle_count;
  quadric_count = geometry.quadric_count;
  instance_count = geometry.instance_count();
  node_count = geometry.bvh.node_count();
  nodes = gpu::make_buffer<glm::uvec4>(device, geometry.bvh.texels);
  primitives = gpu::make_buffer<glm::uvec4>(device, geometry.primitives);
  quadrics = gpu::make_buffer<glm::uvec4>(device, geometry.quadrics);
  instances = gpu::make_buffer<glm::uvec4>(device, geometry.instances);
  details = gpu::make_buffer<glm::uvec4>(device, geometry.details);
  // A texel buffer may hold 2^16 texels only, a storage buffer 2^27 bytes.
  const std::size_t bindable =
      kernels.texel_fetch() ? description.max_texels : description.max_storage_bytes / 16;
  band_pixels = std::min({kBandPixels, std::size_t(film.width) * film.height, bindable / 2});
  most_lanes = std::min<std::uint64_t>(device.is_cpu() ? kCpuBatchLanes : kBatchLanes, bindable);
  sampler_table = gpu::Buffer(device, 16, gpu::Memory::device);
  image_table = gpu::Buffer(device, 16, gpu::Memory::device);
  order = gpu::Buffer(device, 16, gpu::Memory::device);
  for (gpu::Buffer* late : {&filter, &gather_table, &virtual_lights, &paths, &path_hits})
    *late = gpu::Buffer(device, 16, gpu::Memory::device);
  if (!features.shading) {
    for (gpu::Buffer* none : {&materials, &textures, &lights, &environments})
      *none = gpu::Buffer(device, 16, gpu::Memory::device);
  }
  try {
    make_band();
  } catch (const gpu::OutOfMemory&) {
    if (!shrink()) throw;
  }
  tree.grid_origin = glm::vec4(glm::vec3(geometry.bvh.grid_origin), 0);
  tree.grid_scale = glm::vec4(glm::vec3(geometry.bvh.grid_scale), 0);
}

void RendererState::make_band() {
  for (gpu::Buffer* old :
       {&surfaces, &shading, &counts, &samples, &sums, &found, &receivers, &receiver_shading, &receiver_sums})
    *old = gpu::Buffer();
  surfaces = gpu::Buffer(device, 32 * band_pixels, gpu::Memory::device);
  shading = gpu::Buffer(device, features.shading ? 32 * band_pixels : 16, gpu::Memory::device);
  counts = gpu::Buffer(device, 4 * band_pixels, gpu::Memory::host);
  for (gpu::Buffer* late : {&samples, &sums, &found, &receivers, &receiver_shading, &receiver_sums})
    *late = gpu::Buffer(device, 16, gpu::Memory::device);
  bind_again();
}

bool RendererState::shrink() {
  while (band_pixels > kFewestPixels || most_lanes > kFewestLanes) {
    band_pixels = std::max(band_pixels / 2, std::min(band_pixels, kFewestPixels));
    most_lanes = std::max(most_lanes / 2, std::min(most_lanes, kFewestLanes));
    try {
      make_band();
      return true;
    } catch (const gpu::OutOfMemory&) {
    }
  }
  return false;
}

void RendererState::upload_shading(const ShadingData& data, bool everything) {
  warnings = data.warnings;
  light_list = {data.lights.kinds, data.lights.area_lights};
  materials = gpu::make_buffer<glm::uvec4>(device, data.materials.materials);
  textures = gpu::make_buffer<glm::uvec4>(device, data.materials.textures);
  lights = gpu::make_buffer<glm::uvec4>(device, data.lights.lights);
  environments = gpu::make_buffer<glm::uvec4>(device, data.lights.environments);
  // Everything: all code that needs no data of its own (textures, maps) and chooses no other way to find
  // lights (meshes).
  constexpr std::uint32_t kAllMaterials = layout::kHasTexture - 1;
  constexpr std::uint32_t kAllLights = 0xffu & ~(1u << layout::kLightTriangles) & ~(1u << layout::kLightMap);
  scene_constants[layout::kSpecMaterials] = data.materials.kinds | (everything ? kAllMaterials : 0);
  scene_constants[layout::kSpecLightKinds] = data.lights.kind_bits() | (everything ? kAllLights : 0);
  scene_constants[layout::kSpecOctahedral] = data.lights.octahedral ? 1 : 0;
  scene_constants[layout::kSpecDetailNormals] = data.details.normals ? 1 : 0;
  scene_constants[layout::kSpecDetailUvs] = data.details.uvs ? 1 : 0;
}

void RendererState::compile_for(const Job& job) {
  std::vector<KernelVariant> variants;
  if (const auto* occlusion = std::get_if<AmbientOcclusionJob>(&job))
    variants = ambient_occlusion_kernels(*this, *occlusion);
  if (const auto* direct = std::get_if<DirectLightingJob>(&job))
    variants = direct_lighting_kernels(*this, *direct);
  if (const auto* igi = std::get_if<GlobalIlluminationJob>(&job))
    variants = global_illumination_kernels(*this, *igi);
  for (const KernelVariant& variant : variants) kernels.prepare(variant.name, constants(variant));
}

void RendererState::bind_all(gpu::Kernel& kernel, const KernelVariant& variant) const {
  const auto constant = variant.constants.find(layout::kSpecReceivers);
  const bool of_receivers = constant != variant.constants.end() && constant->second != 0;
  const gpu::Buffer& table = variant.name == "primary"        ? image_table
                             : variant.name == "compensation" ? gather_table
                                                              : sampler_table;
  kernel.bind(layout::kBindNodes, nodes);
  kernel.bind(layout::kBindPrimitives, primitives);
  kernel.bind(layout::kBindQuadrics, quadrics);
  kernel.bind(layout::kBindInstances, instances);
  kernel.bind(layout::kBindDetails, details);
  kernel.bind(layout::kBindSampler, table);
  kernel.bind(layout::kBindOrder, order);
  kernel.bind(layout::kBindSurfaces, of_receivers ? receivers : surfaces);
  kernel.bind(layout::kBindShading, of_receivers ? receiver_shading : shading);
  kernel.bind(layout::kBindCounts, counts);
  kernel.bind(layout::kBindPoints, counts);  // until its reader binds its own
  kernel.bind(layout::kBindMaterials, materials);
  kernel.bind(layout::kBindTextures, textures);
  kernel.bind(layout::kBindLights, lights);
  kernel.bind(layout::kBindEnvironment, environments);
  kernel.bind(layout::kBindSamples, samples);
  kernel.bind(layout::kBindSums, of_receivers ? receiver_sums : sums);
  kernel.bind(layout::kBindFilter, filter);
  kernel.bind(layout::kBindVirtualLights, virtual_lights);
  kernel.bind(layout::kBindPaths, paths);
  kernel.bind(layout::kBindPathHits, path_hits);
  kernel.bind(layout::kBindFound, found);
  ray_queue.bind(kernel);
}

void RendererState::bind_again() const {
  for (const Bound& b : bound_) bind_all(*b.kernel, b.variant);
}

void RendererState::grow(gpu::Buffer& buffer, const std::vector<glm::uvec4>& texels) {
  const std::size_t bytes = 16 * texels.size();
  if (bytes > buffer.bytes()) {
    buffer = gpu::Buffer(device, bytes, gpu::Memory::device);
    bind_again();
  }
  buffer.upload(texels.data(), bytes);
}

void RendererState::set_sampler(const SamplerTables& tables, const std::vector<glm::uvec4>& sample_order) {
  grow(sampler_table, tables.texels);
  grow(order, sample_order);
}

void RendererState::set_image_sampler(const SamplerTables& tables) {
  grow(image_table, tables.texels);
}

void RendererState::need_samples() {
  if (samples.bytes() >= 16 * most_lanes && sums.bytes() >= 32 * band_pixels) return;
  samples = gpu::Buffer(device, 16 * most_lanes, gpu::Memory::device);
  sums = gpu::Buffer(device, 32 * band_pixels, gpu::Memory::device);
  filter = gpu::make_buffer<glm::uvec4>(device, gaussian_filter_table());
  bind_again();
}

void RendererState::set_gather_sampler(const SamplerTables& tables) {
  grow(gather_table, tables.texels);
}

void RendererState::need_paths(std::size_t path_count, std::size_t rays) {
  const auto need = [&](gpu::Buffer& buffer, std::size_t bytes) {
    if (buffer.bytes() >= bytes) return;
    buffer = gpu::Buffer(device, bytes, gpu::Memory::device);
  };
  need(paths, 48 * path_count);
  need(path_hits, 80 * path_count);
  need(found, 96 * rays);
  need(receivers, 48 * rays);
  need(receiver_shading, 32 * rays);
  need(receiver_sums, 32 * rays);
  bind_again();
}

Constants RendererState::constants(const KernelVariant& variant) const {
  Constants all = scene_constants;
  for (const auto& [id, value] : variant.constants) all[id] = value;
  return all;
}

KernelVariant RendererState::primary_variant(bool jittered, std::uint32_t sampler_id,
                                             PixelFilter filter_kind) const {
  // Rays from pixel centres need no sampler: one kernel serves all.
  return {"primary",
          {{layout::kSpecSampler, jittered ? sampler_id : layout::kSamplerRandom},
           {layout::kSpecJittered, jittered || features.jittered ? 1 : 0},
           {layout::kSpecFilter, jittered && filter_kind == PixelFilter::gaussian ? 1 : 0}}};
}

gpu::Kernel& RendererState::kernel(const KernelVariant& variant) {
  return kernels.get(variant.name, constants(variant), [&](gpu::Kernel& kernel) {
    bind_all(kernel, variant);
    bound_.push_back({&kernel, variant});
  });
}

std::map<std::string, std::size_t> RendererState::buffer_bytes() const {
  return {
      {"nodes", nodes.bytes()},
      {"primitives", primitives.bytes()},
      {"spheres and disks", quadrics.bytes()},
      {"instances", instances.bytes()},
      {"details", details.bytes()},
      {"materials", materials.bytes()},
      {"textures", textures.bytes()},
      {"lights", lights.bytes()},
      {"environments", environments.bytes()},
      {"samples", samples.bytes() + sums.bytes()},
      {"virtual lights", virtual_lights.bytes()},
      {"light paths", paths.bytes() + path_hits.bytes()},
      {"compensation", found.bytes() + receivers.bytes() + receiver_shading.bytes() + receiver_sums.bytes()},
      {"surfaces", surfaces.bytes()},
      {"shading", shading.bytes()},
      {"counts", counts.bytes()},
      {"sampler", sampler_table.bytes()}};
}

}  // namespace capcon
