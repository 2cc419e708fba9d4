#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "points/point_set.h"

namespace capcon {

/// Sets of `count` points from little-endian coordinates, point by point: floats, or doubles. As read_points
/// has it, 1 becomes 0. InputError unless all lie in [0, 1] and `data` holds just as many bytes; `name`
/// stands in the messages.
std::vector<Points> binary_sets(std::string_view data, bool doubles, std::uint64_t sets, std::uint64_t count,
                                const std::string& name);

}  // namespace capcon
