#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace capcon {

/// Two sets a and b of n cells each swap cells while that raises the sum, within the sets, of d + 0.05 d /
/// (0.3 + d), d the distance of two cells' centres; at most three passes. Returns whether anything was
/// swapped. O(n^2) a pass.
bool swap_cells(const std::vector<glm::vec3>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n);

}  // namespace capcon
