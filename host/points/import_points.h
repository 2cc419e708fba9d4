#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "points/point_set.h"

namespace capcon {

/// Reads point sets that other programs wrote, by the name's ending:
/// - .csv: two columns, separated by comma, semicolon or blanks (one kind in a file); one line of names may
/// come first;
///   empty lines divide nothing. With semicolons, a decimal comma is understood.
/// - .bin: UTK's binary form, little-endian (https://utk-team.github.io/utk/usingutk/ExeUtk/): a header of
/// five 32-bit
///   words, 0x214B5455 ("UTK!"), type (0 int, 1 long, 2 unsigned, 3 unsigned long, 4 float, 5 double, in the
///   first byte), sets, points a set, dimensions; then the coordinates, point by point. Only two dimensions,
///   float and double.
/// - .npy: an array of NumPy's (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html) of
/// shape (points,
///   2) or (sets, points, 2), float32 or float64, little-endian, in C order.
/// - anything else: UTK's text form, see read_points.
/// InputError with file:line, or the place in the file, for what is not such a file.
std::vector<Points> import_points(const std::filesystem::path& path);

/// The same from contents that are already here; `name` stands in the messages.
std::vector<Points> parse_csv_points(std::string_view text, const std::string& name);
std::vector<Points> parse_binary_points(std::string_view bytes, const std::string& name);
std::vector<Points> parse_npy_points(std::string_view bytes, const std::string& name);

}  // namespace capcon
