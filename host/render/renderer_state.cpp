#include "render/renderer_state.h"

#include <fmt/format.h>

#include <chrono>

#include "base/error.h"
#include "render/geometry.h"

namespace capcon {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

RendererState::RendererState(const Scene& scene, const RendererOptions& options)
    : instance(options.validate),
      description(instance.choose(options.device)),
      device(instance, description),
      texel_fetch(options.fetch == "texel" || (options.fetch == "auto" && device.is_cpu())),
      kernels(device, texel_fetch),
      film(scene.film),
      view(make_view(scene.camera, scene.film.width, scene.film.height)) {
  if (options.fetch != "auto" && options.fetch != "texel" && options.fetch != "storage") {
    throw InputError(fmt::format("--fetch {}: choose auto, texel or storage", options.fetch));
  }
  auto start = Clock::now();
  const Geometry geometry = build_geometry(scene);
  setup.wall["build"] = seconds_since(start);
  start = Clock::now();
  triangle_count = geometry.triangle_count;
  quadric_count = geometry.quadric_count;
  node_count = geometry.bvh.node_count();
  nodes = gpu::make_buffer<glm::uvec4>(device, geometry.bvh.texels);
  primitives = gpu::make_buffer<glm::uvec4>(device, geometry.primitives);
  quadrics = gpu::make_buffer<glm::uvec4>(device, geometry.quadrics);
  const std::size_t pixels = std::size_t(film.width) * film.height;
  surfaces = gpu::Buffer(device, 32 * pixels, gpu::Memory::device);
  counts = gpu::Buffer(device, 4 * pixels, gpu::Memory::host);
  sampler_table = gpu::Buffer(device, 16, gpu::Memory::device);
  setup.wall["upload"] = seconds_since(start);
  tree.grid_origin = glm::vec4(glm::vec3(geometry.bvh.grid_origin), 0);
  tree.grid_scale = glm::vec4(glm::vec3(geometry.bvh.grid_scale), 0);
  // The stack's array takes what its seven free registers do not hold; a few sizes rather than every one, so that scenes share
  // kernels in the driver's cache.
  constexpr std::uint32_t kRegisters = 7;
  const std::uint32_t entries = geometry.bvh.stack_entries;
  scene_constants[layout::kSpecStackSize] = entries > kRegisters ? (entries - kRegisters + 3) / 4 * 4 : 1;
  scene_constants[layout::kSpecQuadrics] = quadric_count > 0 ? 1 : 0;
}

void RendererState::bind_all(gpu::Kernel& kernel) const {
  kernel.bind(layout::kBindNodes, nodes);
  kernel.bind(layout::kBindPrimitives, primitives);
  kernel.bind(layout::kBindQuadrics, quadrics);
  kernel.bind(layout::kBindSampler, sampler_table);
  kernel.bind(layout::kBindSurfaces, surfaces);
  kernel.bind(layout::kBindCounts, counts);
  kernel.bind(layout::kBindPoints, counts);  // until its reader binds its own
}

void RendererState::set_sampler(const SamplerTables& tables) {
  const std::size_t bytes = 16 * tables.texels.size();
  if (bytes > sampler_table.bytes()) {
    sampler_table = gpu::Buffer(device, bytes, gpu::Memory::device);
    for (gpu::Kernel* kernel : bound_) kernel->bind(layout::kBindSampler, sampler_table);
  }
  sampler_table.upload(tables.texels.data(), bytes);
}

gpu::Kernel& RendererState::kernel(const std::string& name, std::uint32_t sampler_id, bool jittered) {
  auto constants = scene_constants;
  constants[layout::kSpecSampler] = sampler_id;
  constants[layout::kSpecJittered] = jittered ? 1 : 0;
  return kernels.get(name, constants, [&](gpu::Kernel& kernel) {
    bind_all(kernel);
    bound_.push_back(&kernel);
  });
}

}  // namespace capcon
