#pragma once

#include <cstdint>

namespace capcon {

/// Bits of x at the even places, of y at the odd ones: in this order what is near is mostly near in the
/// plane.
constexpr std::uint64_t morton_code(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t v) {
    v = (v | v << 16) & 0x0000ffff0000ffffu;
    v = (v | v << 8) & 0x00ff00ff00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0fu;
    v = (v | v << 2) & 0x3333333333333333u;
    return (v | v << 1) & 0x5555555555555555u;
  };
  return spread(x) | spread(y) << 1;
}

}  // namespace capcon
