#pragma once

#include <cstdint>

#include "tiling/fixed_point.h"

namespace capcon {

/// floor(a * b / 2^32)
inline std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
}

/// The rotation of the unit disk by turn / 2^32 of a full turn, in the unit square that the concentric map
/// (Shirley and Chiu 1997) takes there: a circle is the rim of a square about the middle, and its angle goes
/// evenly along the rim, so that no sine is needed. 28 bits of each coordinate; the same bits as
/// shaders/sampling/domain_set.glsl.
FixedPoint turn_in_square(FixedPoint p, std::uint32_t turn);

}  // namespace capcon
