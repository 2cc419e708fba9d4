#include "render/kernels.h"

#include <chrono>
#include <span>
#include <utility>
#include <vector>

#include "layout.h"
#include "spirv/bsdf_samples_storage.h"
#include "spirv/bsdf_samples_texel.h"
#include "spirv/compensation_storage.h"
#include "spirv/compensation_texel.h"
#include "spirv/emission_storage.h"
#include "spirv/emission_texel.h"
#include "spirv/emit_paths_storage.h"
#include "spirv/emit_paths_texel.h"
#include "spirv/gather_storage.h"
#include "spirv/gather_texel.h"
#include "spirv/light_samples_storage.h"
#include "spirv/light_samples_texel.h"
#include "spirv/occlusion_storage.h"
#include "spirv/occlusion_texel.h"
#include "spirv/points_storage.h"
#include "spirv/points_texel.h"
#include "spirv/primary_storage.h"
#include "spirv/primary_texel.h"
#include "spirv/rays_storage.h"
#include "spirv/rays_texel.h"
#include "spirv/resolve_storage.h"
#include "spirv/resolve_texel.h"
#include "spirv/trace_paths_storage.h"
#include "spirv/trace_paths_texel.h"

namespace capcon {
namespace {

using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

/// What a kernel reads as data texels and what as plain storage, and the size of its push constants.
struct Description {
  std::span<const std::uint32_t> texel, storage;
  std::vector<std::uint32_t> data_bindings, storage_bindings;
  std::uint32_t push_bytes;
};

/// Of the kernels that shade.
std::vector<std::uint32_t> shading_bindings() {
  using namespace layout;
  return {kBindNodes,    kBindPrimitives,  kBindQuadrics, kBindInstances, kBindSampler,
          kBindSurfaces, kBindShading,     kBindDetails,  kBindMaterials, kBindTextures,
          kBindLights,   kBindEnvironment, kBindOrder};
}

const std::map<std::string, Description>& descriptions() {
  using namespace layout;
  static const std::map<std::string, Description> all = {
      {"primary",
       {k_primary_texel_spirv,
        k_primary_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindSampler, kBindDetails, kBindFilter},
        {kBindSurfaces, kBindShading},
        sizeof(PrimaryConstants)}},
      {"occlusion",
       {k_occlusion_texel_spirv,
        k_occlusion_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindSampler, kBindSurfaces, kBindOrder},
        {kBindCounts, kBindQueue},
        sizeof(OcclusionConstants)}},
      {"light_samples",
       {k_light_samples_texel_spirv,
        k_light_samples_storage_spirv,
        shading_bindings(),
        {kBindSamples},
        sizeof(DirectConstants)}},
      {"bsdf_samples",
       {k_bsdf_samples_texel_spirv,
        k_bsdf_samples_storage_spirv,
        shading_bindings(),
        {kBindSamples},
        sizeof(DirectConstants)}},
      {"resolve",
       {k_resolve_texel_spirv,
        k_resolve_storage_spirv,
        {kBindSamples},
        {kBindSums},
        sizeof(ResolveConstants)}},
      {"emission",
       {k_emission_texel_spirv,
        k_emission_storage_spirv,
        {kBindSurfaces, kBindShading, kBindLights, kBindEnvironment, kBindQuadrics},
        {kBindSums},
        sizeof(EmissionConstants)}},
      {"emit_paths",
       {k_emit_paths_texel_spirv,
        k_emit_paths_storage_spirv,
        {kBindSampler, kBindLights, kBindEnvironment},
        {kBindPaths},
        sizeof(PathConstants)}},
      {"trace_paths",
       {k_trace_paths_texel_spirv,
        k_trace_paths_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindSampler, kBindDetails,
         kBindMaterials, kBindTextures},
        {kBindPaths, kBindPathHits},
        sizeof(PathConstants)}},
      {"gather",
       {k_gather_texel_spirv,
        k_gather_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindSurfaces, kBindShading,
         kBindMaterials, kBindTextures, kBindVirtualLights},
        {kBindSamples},
        sizeof(GatherConstants)}},
      {"compensation",
       {k_compensation_texel_spirv,
        k_compensation_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindSampler, kBindSurfaces,
         kBindShading, kBindDetails, kBindMaterials, kBindTextures},
        {kBindFound},
        sizeof(CompensationConstants)}},
      {"rays",
       {k_rays_texel_spirv,
        k_rays_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindInstances, kBindRays},
        {kBindHits, kBindQueue},
        sizeof(RayConstants)}},
      {"points",
       {k_points_texel_spirv,
        k_points_storage_spirv,
        {kBindSampler},
        {kBindPoints},
        sizeof(PointConstants)}}};
  return all;
}

}  // namespace

Kernels::Kernels(const gpu::Device& device, bool texel_fetch)
    : device_(device), texel_fetch_(texel_fetch), nothing_(device, 4096, gpu::Memory::device) {
  nothing_.clear();
}

void Kernels::set_texel_fetch(bool texel_fetch) {
  if (texel_fetch == texel_fetch_) return;
  kernels_.clear();
  texel_fetch_ = texel_fetch;
}

Kernels::Entry& Kernels::compiled(const std::string& name, const Constants& constants) {
  Entry& entry = kernels_[{name, constants}];
  if (!entry.kernel) {
    const auto start = Clock::now();
    auto kernel = make(name, constants);
    warm_up(*kernel);
    entry.kernel = std::move(kernel);
    compile_seconds_ += Seconds(Clock::now() - start).count();
  }
  return entry;
}

std::unique_ptr<gpu::Kernel> Kernels::make(const std::string& name, const Constants& constants) {
  const Description& d = descriptions().at(name);
  std::map<std::uint32_t, gpu::Access> bindings;
  for (const std::uint32_t b : d.data_bindings)
    bindings[b] = texel_fetch_ ? gpu::Access::texels : gpu::Access::storage;
  for (const std::uint32_t b : d.storage_bindings) bindings[b] = gpu::Access::storage;
  return std::make_unique<gpu::Kernel>(device_, texel_fetch_ ? d.texel : d.storage, bindings, constants,
                                       d.push_bytes);
}

void Kernels::warm_up(gpu::Kernel& kernel) {
  for (std::uint32_t binding = 0; binding < layout::kBindCount; ++binding) kernel.bind(binding, nothing_);
  const std::vector<std::uint32_t> zeros(kernel.push_bytes() / 4);  // zero pixels, zero samples
  gpu::Commands commands(device_);
  commands.dispatch(kernel, zeros.data(), 1, "warm up");
  commands.submit_and_wait();
}

double Kernels::take_compile_seconds() {
  return std::exchange(compile_seconds_, 0.0);
}

}  // namespace capcon
