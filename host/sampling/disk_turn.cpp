#include "sampling/disk_turn.h"

#include <algorithm>
#include <cstdlib>

namespace capcon {

FixedPoint turn_in_square(FixedPoint p, std::uint32_t turn) {
  const auto x = static_cast<std::int32_t>(p.x ^ 0x80000000u) >> 4,
             y = static_cast<std::int32_t>(p.y ^ 0x80000000u) >> 4;
  const std::int32_t r = std::max(std::abs(x), std::abs(y));
  const bool wide = std::abs(x) >= std::abs(y);
  auto along =
      static_cast<std::uint32_t>(wide ? (x > 0 ? y + r : 5 * r - y) : (y > 0 ? 3 * r - x : 7 * r + x));
  const std::uint32_t rim = 8u * static_cast<std::uint32_t>(r);
  along += multiply_high(turn, rim);
  if (along >= rim) along -= rim;
  const std::uint32_t side = r == 0 ? 0 : along / (2u * static_cast<std::uint32_t>(r));
  const std::int32_t rest = static_cast<std::int32_t>(along - side * 2u * static_cast<std::uint32_t>(r)) - r;
  const std::int32_t u = side == 0 ? r : side == 1 ? -rest : side == 2 ? -r : rest;
  const std::int32_t v = side == 0 ? rest : side == 1 ? r : side == 2 ? -rest : -r;
  const auto fixed = [](std::int32_t c) {
    return (static_cast<std::uint32_t>(std::min(c, 0x7ffffff)) << 4) ^ 0x80000000u;
  };
  return {fixed(u), fixed(v)};
}

}  // namespace capcon
