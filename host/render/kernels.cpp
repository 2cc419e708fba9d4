#include "render/kernels.h"

#include <chrono>
#include <span>
#include <utility>
#include <vector>

#include "layout.h"
#include "spirv/occlusion_storage.h"
#include "spirv/occlusion_texel.h"
#include "spirv/points_storage.h"
#include "spirv/points_texel.h"
#include "spirv/primary_storage.h"
#include "spirv/primary_texel.h"
#include "spirv/rays_storage.h"
#include "spirv/rays_texel.h"

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

const std::map<std::string, Description>& descriptions() {
  using namespace layout;
  static const std::map<std::string, Description> all = {
      {"primary",
       {k_primary_texel_spirv,
        k_primary_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindSampler},
        {kBindSurfaces},
        sizeof(PrimaryConstants)}},
      {"occlusion",
       {k_occlusion_texel_spirv,
        k_occlusion_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindSampler, kBindSurfaces},
        {kBindCounts},
        sizeof(OcclusionConstants)}},
      {"rays",
       {k_rays_texel_spirv,
        k_rays_storage_spirv,
        {kBindNodes, kBindPrimitives, kBindQuadrics, kBindRays},
        {kBindHits},
        sizeof(RayConstants)}},
      {"points", {k_points_texel_spirv, k_points_storage_spirv, {kBindSampler}, {kBindPoints}, sizeof(OcclusionConstants)}}};
  return all;
}

}  // namespace

std::unique_ptr<gpu::Kernel> Kernels::make(const std::string& name, const std::map<std::uint32_t, std::uint32_t>& constants) {
  const auto start = Clock::now();
  const Description& d = descriptions().at(name);
  std::map<std::uint32_t, gpu::Access> bindings;
  for (const std::uint32_t b : d.data_bindings) bindings[b] = texel_fetch_ ? gpu::Access::texels : gpu::Access::storage;
  for (const std::uint32_t b : d.storage_bindings) bindings[b] = gpu::Access::storage;
  auto kernel =
      std::make_unique<gpu::Kernel>(device_, texel_fetch_ ? d.texel : d.storage, bindings, constants, d.push_bytes);
  compile_seconds_ += Seconds(Clock::now() - start).count();
  return kernel;
}

void Kernels::warm_up(const gpu::Kernel& kernel) {
  const auto start = Clock::now();
  const std::vector<std::uint32_t> nothing(kernel.push_bytes() / 4);  // zero pixels, zero samples
  gpu::Commands commands(device_);
  commands.dispatch(kernel, nothing.data(), 1, "warm up");
  commands.submit_and_wait();
  compile_seconds_ += Seconds(Clock::now() - start).count();
}

double Kernels::take_compile_seconds() { return std::exchange(compile_seconds_, 0.0); }

}  // namespace capcon
