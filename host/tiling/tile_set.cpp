#include "tiling/tile_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"

namespace capcon {

FixedPoint to_fixed(glm::dvec2 p) {
  const auto one = [](double v) { return std::uint32_t(std::int64_t(std::floor(v * 0x1p32 + 0.5))); };
  return {one(p.x), one(p.y)};
}

glm::dvec2 to_double(FixedPoint p) {
  return {p.x * 0x1p-32, p.y * 0x1p-32};
}

std::string_view region_name(RegionKind kind) {
  switch (kind) {
    case RegionKind::corner:
      return "corner";
    case RegionKind::horizontal_edge:
      return "horizontal";
    case RegionKind::vertical_edge:
      return "vertical";
    default:
      return "interior";
  }
}

namespace {

std::string body(const TileSet& set) {
  std::string text = fmt::format("capcon-tiles 1\ncolours {}\npoints {}\nrecipe {}\n", set.colours,
                                 set.points_per_tile, set.recipe);
  for (std::size_t t = 0; t < set.tiles.size(); ++t) {
    text += fmt::format("tile {}\n", t);
    for (const TileSet::TilePoint& p : set.tiles[t])
      text +=
          fmt::format("{} {} {} {} {}\n", p.position.x, p.position.y, region_name(p.kind), p.region, p.slot);
  }
  return text;
}

}  // namespace

std::uint64_t checksum(const TileSet& set) {
  return fnv1a64(body(set));
}

std::string format_tile_set(const TileSet& set) {
  const std::string text = body(set);
  return text + fmt::format("checksum fnv1a64 {:016x}\n", fnv1a64(text));
}

void write_tile_set(const std::filesystem::path& path, const TileSet& set) {
  write_file(path, format_tile_set(set));
}

TileSet read_tile_set(const std::filesystem::path& path) {
  return parse_tile_set(read_file(path), path.string());
}

TileSet shipped_tile_set(std::uint32_t colours, std::uint32_t points_per_tile) {
  return read_tile_set(shipped_file(fmt::format("tiles/c{}n{}.tiles", colours, points_per_tile)));
}

}  // namespace capcon
