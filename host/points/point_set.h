#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace capcon {

/// Points of the unit torus, coordinates in [0, 1).
using Points = std::vector<glm::dvec2>;

/// Reads UTK's text form: one "x y" a line, '#' alone on a line between sets (one at the very end is
/// tolerated, and so are empty lines). Every set of the file in order; a coordinate of exactly 1 becomes 0,
/// its place on the torus. InputError with file:line for anything that is not a pair of finite numbers in [0,
/// 1], for a set without a point, or when there is no point at all.
std::vector<Points> read_points(const std::filesystem::path& path);

/// The same from text that is already here; `name` stands in the messages.
std::vector<Points> parse_points(std::string_view text, const std::string& name);

/// Writes the same form with 17 digits, so that reading gives the same bits.
void write_points(const std::filesystem::path& path, const std::vector<Points>& sets);

/// What write_points writes.
std::string format_points(const std::vector<Points>& sets);

}  // namespace capcon
