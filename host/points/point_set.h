#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// Points of the unit torus, coordinates in [0, 1).
using Points = std::vector<glm::dvec2>;

/// Reads UTK's text form: one "x y" a line, '#' alone on a line between sets. Every set of the file in order.
/// InputError with file:line for anything that is not a pair of finite numbers in [0, 1], or when there is no point.
std::vector<Points> read_points(const std::filesystem::path& path);

/// Writes the same form with 17 digits, so that reading gives the same bits.
void write_points(const std::filesystem::path& path, const std::vector<Points>& sets);

}  // namespace capcon
