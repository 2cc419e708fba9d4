#include "render/sample_order.h"

#include <algorithm>
#include <numeric>

namespace capcon {
namespace {

constexpr std::uint32_t kFewest = 16;  // two groups of eight lanes
constexpr std::uint32_t kMost =
    1u << 16;  // a megabyte of texels; beyond, neighbours by index are close enough

/// Bits of x at the even places, of y at the odd ones, highest first.
std::uint64_t morton(FixedPoint p) {
  const auto spread = [](std::uint64_t v) {
    v = (v | v << 16) & 0x0000ffff0000ffffu;
    v = (v | v << 8) & 0x00ff00ff00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0fu;
    v = (v | v << 2) & 0x3333333333333333u;
    return (v | v << 1) & 0x5555555555555555u;
  };
  return spread(p.x) | spread(p.y) << 1;
}

}  // namespace

std::vector<glm::uvec4> sample_order(const Sampler& sampler) {
  const std::uint32_t count = sampler.count();
  const bool gains =
      sampler.name() == "sobol-xor" || sampler.name() == "sobol-owen" || sampler.name() == "jittered";
  if (!gains || count < kFewest || count > kMost) return {};
  std::vector<std::uint64_t> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) keys[i] = morton(sampler.sample(0, i, 0, SampleDomain::disk));
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
