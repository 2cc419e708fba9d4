#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// Two sets a and b of n cells each swap cells while that raises the sum of the distances within the sets, at
/// most three passes. Returns whether anything was swapped. O(n^2) a pass.
bool swap_cells(const std::vector<glm::vec2>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n);

}  // namespace capcon
