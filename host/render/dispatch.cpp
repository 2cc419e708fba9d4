#include "render/dispatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "layout.h"

namespace capcon {
namespace {

// The product of a group and the stride is a word: 0.62 * 2^32 at most.
constexpr std::uint32_t kMostSpread = 1u << 16;

}  // namespace

std::uint32_t groups_for(std::uint64_t lanes) {
  return static_cast<std::uint32_t>((lanes + layout::kGroupSize - 1) / layout::kGroupSize);
}

std::uint32_t spreading_stride(std::uint32_t groups) {
  if (groups > kMostSpread) return 1;
  auto stride = std::max(1u, static_cast<std::uint32_t>(std::lround(groups * 0.61803398875)));
  while (std::gcd(stride, groups) != 1) ++stride;
  return stride;
}

}  // namespace capcon
