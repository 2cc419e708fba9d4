#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sampling/tiling_parts.h"

namespace capcon {

/// The parts of one split: sets of `count` points in `parts` parts.
struct StoredParts {
  std::uint32_t count = 0, parts = 0;
  TilingParts dealt;
};

/// The parts of some splits and the tile set they belong to, by its checksum (tile_set.h).
struct PartsFile {
  std::uint64_t tiles = 0;
  std::vector<StoredParts> splits;
};

/// The most points of a set that a file can hold: a point's number is a byte.
constexpr std::uint32_t kMostStoredPoints = 256;

/// As bytes (docs/tile-format.md): magic, version, the splits, a checksum. At most kMostStoredPoints points.
std::string format_parts(const PartsFile& file);

/// The same from bytes; `name` stands in messages. InputError for another magic or version, a wrong checksum,
/// a file cut short or too long, and orders that do not hold every point once: the parts' union would not be
/// the set.
PartsFile parse_parts(std::string_view bytes, const std::string& name);

}  // namespace capcon
