#include "render/sample_order.h"

#include <algorithm>
#include <numeric>

#include "base/morton.h"

namespace capcon {
namespace {

constexpr std::uint32_t kFewest = 16;  // two groups of eight lanes
constexpr std::uint32_t kMost =
    1u << 16;  // a megabyte of texels; beyond, neighbours by index are close enough

}  // namespace

std::vector<glm::uvec4> sample_order(const Sampler& sampler) {
  const std::uint32_t count = sampler.count();
  const bool gains = sampler.name() == "sobol-xor" || sampler.name() == "sobol-owen" ||
                     sampler.name() == "pmj02" || sampler.name() == "jittered";
  if (!gains || count < kFewest || count > kMost) return {};
  std::vector<std::uint64_t> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const FixedPoint p = sampler.sample(0, i, 0, SampleDomain::disk);
    keys[i] = morton_code(p.x, p.y);
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  std::vector<glm::uvec4> texels;
  texels.reserve(count);
  for (const std::uint32_t i : order) texels.emplace_back(i, 0, 0, 0);
  return texels;
}

}  // namespace capcon
