#include "render/light_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>

#include "base/error.h"
#include "gpu/commands.h"
#include "render/dispatch.h"

namespace capcon {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr std::uint32_t kTexels = 5;          // a VPL
constexpr std::uint32_t kMostBounces = 1000;  // goes on with 63/64 at most: reached by one path in 7 million
constexpr double kLargerBounds = 1.001;       // so that paths from afar start outside of everything

/// The domains of origins and directions: of a single light its own, else squares (docs/igi.md).
std::vector<SampleDomain> domains_of(const std::vector<std::uint32_t>& kinds) {
  std::vector<SampleDomain> domains = {SampleDomain::disk, SampleDomain::square};
  const std::uint32_t kind = kinds.front();
  if (kinds.size() == 1 && (kind == layout::kLightSphere || kind > layout::kLightTriangles))
    domains.push_back(SampleDomain::cylinder);
  return domains;
}

/// One job's paths under way.
class LightPaths {
 public:
  LightPaths(RendererState& state, const GlobalIlluminationJob& job, Timings& timings)
      : s_(state), job_(job), timings_(timings), batches_(state.batches()), sets_(job.sets) {}

  DeviceVirtualLights run() {
    start();
    for (push_.bounce = 1; push_.bounce <= kMostBounces; ++push_.bounce) {
      lights_.rays += push_.count;
      dispatch(*trace_);
      if (collect() == 0) break;
    }
    return join();
  }

 private:
  void start() {
    auto begin = Clock::now();
    const auto sampler = path_sampler(job_);
    const SamplerTables tables = sampler->tables(domains_of(s_.light_list.kinds));
    s_.set_sampler(tables);
    timings_.wall["points"] += seconds_since(begin);
    const auto variants = light_path_kernels(tables.id);
    const std::uint32_t paths = job_.paths * job_.sets;
    s_.need_paths(paths, 0);
    gpu::Kernel& emit = s_.kernel(variants[0]);
    trace_ = &s_.kernel(variants[1]);
    push_.tree = s_.tree;
    push_.words = {tables.constants[0], tables.constants[1], tables.constants[2], tables.constants[3]};
    push_.split = {job_.sets, job_.paths, sampler->split().part_stride, sampler->split().point_stride};
    push_.bounds =
        glm::vec4(glm::vec3(s_.bounds.centre), static_cast<float>(kLargerBounds * s_.bounds.radius));
    push_.seed = path_seed(job_.direct.seed);
    push_.count = paths;
    push_.flags = job_.partition ? 0 : layout::kDirectSeparate;
    push_.lights = static_cast<std::uint32_t>(s_.light_list.kinds.size());
    dispatch(emit);
  }

  void dispatch(gpu::Kernel& kernel) {
    const auto begin = Clock::now();
    for (push_.first = 0; push_.first < push_.count; push_.first += push_.batch) {
      push_.batch = static_cast<std::uint32_t>(
          std::min<std::uint64_t>(batches_.lanes(kernel), push_.count - push_.first));
      gpu::Commands commands(s_.device);
      commands.dispatch(kernel, &push_, groups_for(push_.batch), "light paths");
      commands.submit_and_wait();
      const double seconds = commands.times().front().seconds;
      batches_.took(kernel, push_.batch, seconds);
      timings_.device["light paths"] += seconds;
    }
    timings_.wall["light paths"] += seconds_since(begin);
  }

  /// Takes what this bounce hit; how many paths did.
  std::size_t collect() {
    std::vector<glm::uvec4> hits(std::size_t(kTexels) * push_.count);
    s_.path_hits.download(hits.data(), 16 * hits.size());
    std::size_t count = 0;
    for (std::uint32_t path = 0; path < push_.count; ++path) {
      const glm::uvec4* hit = &hits[std::size_t(kTexels) * path];
      if (hit[2].w == 0) continue;
      ++count;
      Set& set = sets_[path / job_.paths];
      set.texels.insert(set.texels.end(), hit, hit + kTexels);
      set.path_and_bounce.emplace_back(path % job_.paths, push_.bounce);
    }
    return count;
  }

  DeviceVirtualLights join() {
    for (const Set& set : sets_) {
      lights_.texels.insert(lights_.texels.end(), set.texels.begin(), set.texels.end());
      lights_.path_and_bounce.insert(lights_.path_and_bounce.end(), set.path_and_bounce.begin(),
                                     set.path_and_bounce.end());
      lights_.first.push_back(static_cast<std::uint32_t>(lights_.path_and_bounce.size()));
    }
    return std::move(lights_);
  }

  struct Set {
    std::vector<glm::uvec4> texels;
    std::vector<glm::uvec2> path_and_bounce;
  };

  RendererState& s_;
  const GlobalIlluminationJob& job_;
  Timings& timings_;
  Batches batches_;
  gpu::Kernel* trace_ = nullptr;
  layout::PathConstants push_{};
  std::vector<Set> sets_;
  DeviceVirtualLights lights_;
};

glm::dvec3 floats(const glm::uvec4& texel) {
  return {std::bit_cast<float>(texel.x), std::bit_cast<float>(texel.y), std::bit_cast<float>(texel.z)};
}

}  // namespace

std::unique_ptr<Sampler> path_sampler(const GlobalIlluminationJob& job) {
  const std::uint32_t seed = path_seed(job.direct.seed);
  return job.partition ? make_sampler(job.sampler, job.paths * job.sets, seed, job.sets)
                       : make_sampler(job.sampler, job.paths, seed);
}

std::vector<KernelVariant> light_path_kernels(std::uint32_t sampler_id) {
  return {{"emit_paths", {{layout::kSpecSampler, sampler_id}}},
          {"trace_paths", {{layout::kSpecSampler, sampler_id}}}};
}

DeviceVirtualLights trace_light_paths(RendererState& state, const GlobalIlluminationJob& job,
                                      Timings& timings) {
  if (state.light_list.kinds.empty())
    throw InputError("the scene has no light that emits; add one, such as LightSource or AreaLightSource");
  DeviceVirtualLights lights = LightPaths(state, job, timings).run();
  if (lights.texels.empty())
    throw InputError("no light path hits a surface; turn the lights to the scene, or trace more paths");
  const std::size_t bytes = 16 * lights.texels.size();
  const bool fits = state.kernels.texel_fetch() ? lights.texels.size() <= state.description.max_texels
                                                : bytes <= state.description.max_storage_bytes;
  if (!fits) {
    throw Failure(fmt::format(
        "{} virtual lights take {:.1f} MiB, more than {} binds at once: fewer paths or sets",
        lights.texels.size() / kTexels, static_cast<double>(bytes) / (1 << 20), state.description.name));
  }
  return lights;
}

VirtualLights unpack(const DeviceVirtualLights& lights, const Placement& placement,
                     std::uint32_t default_material) {
  VirtualLights all;
  all.first = lights.first;
  for (std::size_t k = 0; k < lights.path_and_bounce.size(); ++k) {
    const glm::uvec4* t = &lights.texels[kTexels * k];
    VirtualLight light;
    light.position = placement.to_world(floats(t[0]));
    light.primitive = t[0].w;
    light.normal = floats(t[1]);
    light.material = t[1].w == default_material ? -1 : static_cast<int>(t[1].w);
    light.flux = glm::dvec3(floats(t[2])) / (placement.scale * placement.scale);
    light.shading_normal = floats(t[3]);
    light.arriving = floats(t[4]);
    light.uv = {std::bit_cast<float>(t[3].w), std::bit_cast<float>(t[4].w)};
    light.path = lights.path_and_bounce[k].x;
    light.bounce = lights.path_and_bounce[k].y;
    all.lights.push_back(light);
  }
  return all;
}

}  // namespace capcon
