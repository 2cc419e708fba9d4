#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace capcon {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in the binary formats.
std::size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of a list's items
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t data_start = 0;  ///< offset of the first byte behind the header
};

/// Reads the header of a PLY file (Greg Turk's format, 1994). InputError with file:line for what is
/// malformed, and when the file is too short for the counts it promises: what a count allows may be
/// allocated.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace capcon
