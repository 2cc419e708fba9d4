#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace capcon {

/// A coordinate pair in [0, 1)^2 as 0.32 fixed point: x / 2^32. Rotation on the torus is 32-bit addition.
struct FixedPoint {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  bool operator==(const FixedPoint&) const = default;
};

FixedPoint to_fixed(glm::dvec2 p);
glm::dvec2 to_double(FixedPoint p);

}  // namespace capcon
