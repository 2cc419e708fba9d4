#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace capcon {

/// What swaps raise the sum of within a set: the distance, and a short-ranged part that decides where
/// half-planes leave a choice, as between all pairs of two points on opposite sides of the middle.
inline float spread_distance(float dx, float dy, float dz) {
  constexpr float kShort = 0.05f, kRange = 0.3f;
  const float d = std::sqrt(dx * dx + dy * dy + dz * dz);
  return d + kShort * d / (kRange + d);
}

/// Two sets a and b of n cells each swap cells while that raises the sum, within the sets, of d + 0.05 d /
/// (0.3 + d), d the distance of two cells' centres; at most three passes. Returns whether anything was
/// swapped. O(n^2) a pass.
bool swap_cells(const std::vector<glm::vec3>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n);

}  // namespace capcon
