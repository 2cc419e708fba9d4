#include "tiling/tile_set.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"

namespace capcon {

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
  const bool complete = set.colouring == Colouring::free;
  std::string text = fmt::format("capcon-tiles {}\ncolours {}\npoints {}\n",
                                 complete        ? 1
                                 : set.bounded() ? 3
                                                 : 2,
                                 set.colours, set.points_per_tile);
  if (!complete) text += fmt::format("colouring {}\n", colouring_name(set.colouring));
  text += fmt::format("recipe {}\n", set.recipe);
  for (const std::uint32_t t : tile_numbers(set.colours, set.colouring)) {
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
  return shipped_tile_set(fmt::format("c{}n{}", colours, points_per_tile));
}

TileSet shipped_tile_set(const std::string& name) {
  return read_tile_set(shipped_file("tiles/" + name + ".tiles"));
}

}  // namespace capcon
