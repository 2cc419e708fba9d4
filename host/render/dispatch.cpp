#include "render/dispatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "layout.h"

namespace capcon {

std::uint32_t groups_for(std::uint64_t lanes) {
  return static_cast<std::uint32_t>((lanes + layout::kGroupSize - 1) / layout::kGroupSize);
}

std::uint32_t spreading_stride(std::uint32_t groups) {
  auto stride = std::max(1u, static_cast<std::uint32_t>(std::lround(groups * 0.61803398875)));
  while (std::gcd(stride, groups) != 1) ++stride;
  return stride;
}

}  // namespace capcon
