#include "tiling/fixed_point.h"

#include <cmath>

namespace capcon {

FixedPoint to_fixed(glm::dvec2 p) {
  const auto one = [](double v) { return std::uint32_t(std::int64_t(std::floor(v * 0x1p32 + 0.5))); };
  return {one(p.x), one(p.y)};
}

glm::dvec2 to_double(FixedPoint p) {
  return {p.x * 0x1p-32, p.y * 0x1p-32};
}

}  // namespace capcon
