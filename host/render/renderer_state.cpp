#include "render/renderer_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>

#include "base/error.h"
#include "render/geometry.h"
#include "render/sample_order.h"

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

/// The images of a scene, one after the other, for a buffer.
std::vector<float> image_words(const Scene& scene) {
  std::vector<float> words;
  for (const SceneImage& image : scene.images)
    words.insert(words.end(), image.image.pixels.begin(), image.image.pixels.end());
  words.resize((words.size() + 3) / 4 * 4);
  return words;
}

}  // namespace

RendererState::RendererState(const Scene& scene, const RendererOptions& options,
                             std::unique_ptr<DeviceContext> opened, const AmbientOcclusionJob* first)
    : context(std::move(opened)),
      description(context->description),
      device(context->device),
      kernels(context->kernels),
      features(options.keep_everything ? all_features(scene, options.instancing)
                                       : needed_features(scene, first, options.instancing)),
      film(scene.film),
      view(make_view(scene.camera, scene.film.width, scene.film.height)) {
  scene_constants[layout::kSpecQuadrics] = features.quadrics ? 1 : 0;
  scene_constants[layout::kSpecInstances] = features.two_level ? 1 : 0;
  scene_constants[layout::kSpecDetails] = features.details ? 1 : 0;
  scene_constants[layout::kSpecStackSize] = stack_array(0);
  setup.wall["device"] = context->open_seconds;
  check_size(scene, wants_two_levels(scene, options.instancing), description);
  auto start = Clock::now();
  std::future<void> compiling;
  if (first) compiling = std::async(std::launch::async, [&] { compile_for(*first); });
  // With everything kept the code of both levels is there, and the image stays the same: instances are
  // written out as before.
  Geometry geometry;
  try {
    const bool keep_instances = wants_two_levels(scene, options.instancing);
    geometry = build_geometry(scene, {.two_level = features.two_level,
                                      .keep_instances = keep_instances,
                                      .details = features.details,
                                      .cut = wants_best_tree(scene, keep_instances, first, options.tree)});
  } catch (...) {
    if (compiling.valid()) compiling.wait();
    throw;
  }
  setup.wall["build"] = seconds_since(start);
  if (compiling.valid()) compiling.get();
  start = Clock::now();
  scene_constants[layout::kSpecStackSize] = stack_array(geometry.bvh.stack_entries);
  const std::size_t largest = std::max(geometry.bvh.texels.size(), geometry.primitives.size()) * 16;
  if (options.fetch == "auto" && !fits(description, largest, kernels.texel_fetch())) {
    kernels.set_texel_fetch(fits(description, largest, true));
  }
  upload(scene, geometry);
  setup.wall["upload"] = seconds_since(start);
}

void RendererState::upload(const Scene& scene, const Geometry& geometry) {
  triangle_count = geometry.triangle_count;
  quadric_count = geometry.quadric_count;
  instance_count = geometry.instance_count();
  node_count = geometry.bvh.node_count();
  nodes = gpu::make_buffer<glm::uvec4>(device, geometry.bvh.texels);
  primitives = gpu::make_buffer<glm::uvec4>(device, geometry.primitives);
  quadrics = gpu::make_buffer<glm::uvec4>(device, geometry.quadrics);
  instances = gpu::make_buffer<glm::uvec4>(device, geometry.instances);
  details = gpu::make_buffer<glm::uvec4>(device, geometry.details);
  images = gpu::make_buffer<float>(device, features.images ? image_words(scene) : std::vector<float>());
  band_pixels = std::min(kBandPixels, std::size_t(film.width) * film.height);
  surfaces = gpu::Buffer(device, 32 * band_pixels, gpu::Memory::device);
  shading = gpu::Buffer(device, features.details ? 32 * band_pixels : 16, gpu::Memory::device);
  counts = gpu::Buffer(device, 4 * band_pixels, gpu::Memory::host);
  sampler_table = gpu::Buffer(device, 16, gpu::Memory::device);
  order = gpu::Buffer(device, 16, gpu::Memory::device);
  tree.grid_origin = glm::vec4(glm::vec3(geometry.bvh.grid_origin), 0);
  tree.grid_scale = glm::vec4(glm::vec3(geometry.bvh.grid_scale), 0);
}

void RendererState::compile_for(const AmbientOcclusionJob& job) {
  const bool jittered = job.position == PixelPosition::jittered;
  const auto sampler = make_sampler(job.sampler, job.samples, job.seed);
  const std::uint32_t id = sampler->tables({}).id;
  kernels.prepare("primary", constants(jittered ? id : layout::kSamplerRandom, jittered, false));
  kernels.prepare("occlusion", constants(id, false, !jittered && !sample_order(*sampler).empty()));
}

void RendererState::bind_all(gpu::Kernel& kernel) const {
  kernel.bind(layout::kBindNodes, nodes);
  kernel.bind(layout::kBindPrimitives, primitives);
  kernel.bind(layout::kBindQuadrics, quadrics);
  kernel.bind(layout::kBindInstances, instances);
  kernel.bind(layout::kBindDetails, details);
  kernel.bind(layout::kBindSampler, sampler_table);
  kernel.bind(layout::kBindOrder, order);
  kernel.bind(layout::kBindSurfaces, surfaces);
  kernel.bind(layout::kBindShading, shading);
  kernel.bind(layout::kBindCounts, counts);
  kernel.bind(layout::kBindPoints, counts);  // until its reader binds its own
}

void RendererState::grow(gpu::Buffer& buffer, std::uint32_t binding, const std::vector<glm::uvec4>& texels) {
  const std::size_t bytes = 16 * texels.size();
  if (bytes > buffer.bytes()) {
    buffer = gpu::Buffer(device, bytes, gpu::Memory::device);
    for (gpu::Kernel* kernel : bound_) kernel->bind(binding, buffer);
  }
  buffer.upload(texels.data(), bytes);
}

void RendererState::set_sampler(const SamplerTables& tables, const std::vector<glm::uvec4>& sample_order) {
  grow(sampler_table, layout::kBindSampler, tables.texels);
  grow(order, layout::kBindOrder, sample_order);
}

Constants RendererState::constants(std::uint32_t sampler_id, bool jittered, bool ordered) const {
  Constants all = scene_constants;
  all[layout::kSpecSampler] = sampler_id;
  all[layout::kSpecJittered] = jittered || features.jittered ? 1 : 0;
  all[layout::kSpecOrdered] = ordered ? 1 : 0;
  return all;
}

gpu::Kernel& RendererState::kernel(const std::string& name, std::uint32_t sampler_id, bool jittered,
                                   bool ordered) {
  return kernels.get(name, constants(sampler_id, jittered, ordered), [&](gpu::Kernel& kernel) {
    bind_all(kernel);
    bound_.push_back(&kernel);
  });
}

std::map<std::string, std::size_t> RendererState::buffer_bytes() const {
  return {{"nodes", nodes.bytes()},
          {"primitives", primitives.bytes()},
          {"spheres and disks", quadrics.bytes()},
          {"instances", instances.bytes()},
          {"details", details.bytes()},
          {"images", images.bytes()},
          {"surfaces", surfaces.bytes()},
          {"shading", shading.bytes()},
          {"counts", counts.bytes()},
          {"sampler", sampler_table.bytes()}};
}

}  // namespace capcon
