#include "tiling/region_layout.h"

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace capcon {

std::uint32_t tile_count(std::uint32_t colours) {
  return colours * colours * colours * colours;
}

std::array<std::uint32_t, 4> tile_colours(std::uint32_t colours, std::uint32_t tile) {
  std::array<std::uint32_t, 4> result;
  for (std::uint32_t& colour : result) colour = tile % colours, tile /= colours;
  return result;
}

std::uint32_t part_count(RegionKind kind) {
  return kind == RegionKind::corner ? 4 : kind == RegionKind::interior ? 1 : 2;
}

std::uint32_t tile_region(std::uint32_t colours, std::uint32_t tile, RegionKind kind, std::uint32_t part) {
  const std::array<std::uint32_t, 4> c = tile_colours(colours, tile);
  switch (kind) {
    case RegionKind::corner:
      return c[part];
    case RegionKind::horizontal_edge:
      return c[2 * part] + colours * c[2 * part + 1];
    case RegionKind::vertical_edge:
      return c[part] + colours * c[part + 2];
    default:
      return tile;
  }
}

namespace {

using Key = std::tuple<RegionKind, std::uint32_t, std::uint32_t>;  // kind, region, slot

struct Copies {
  std::size_t first_tile = 0, first_rank = 0;
  FixedPoint position;
  std::vector<bool> in_tile;
};

// A slot is one part's: the tiles that hold it must be all those that show the region at that part.
bool is_some_part(const TileSet& set, const Key& key, const std::vector<bool>& in_tile) {
  const auto& [kind, region, slot] = key;
  for (std::uint32_t part = 0; part < part_count(kind); ++part) {
    bool same = true;
    for (const std::uint32_t t : tile_numbers(set.colours, set.colouring))
      same = same && in_tile[t] == (tile_region(set.colours, t, kind, part) == region);
    if (same) return true;
  }
  return false;
}

}  // namespace

std::optional<RegionFault> find_region_fault(const TileSet& set) {
  std::map<Key, Copies> slots;
  for (std::size_t t = 0; t < set.tiles.size(); ++t)
    for (std::size_t r = 0; r < set.tiles[t].size(); ++r) {
      const TileSet::TilePoint& p = set.tiles[t][r];
      for (std::size_t q = 0; q < r; ++q)
        if (set.tiles[t][q].position == p.position)
          return RegionFault{t, r, "the tile holds this point twice"};
      auto [slot, is_new] = slots.try_emplace({p.kind, p.region, p.slot});
      Copies& copies = slot->second;
      if (is_new) copies = {t, r, p.position, std::vector<bool>(set.tiles.size())};
      if (copies.in_tile[t]) return RegionFault{t, r, "the tile holds this slot of this region twice"};
      if (copies.position != p.position)
        return RegionFault{
            t, r,
            fmt::format("the same slot of the same region lies elsewhere in tile {}: copies of a "
                        "region must hold the same points",
                        copies.first_tile)};
      copies.in_tile[t] = true;
    }
  for (const auto& [key, copies] : slots)
    if (!is_some_part(set, key, copies.in_tile))
      return RegionFault{copies.first_tile, copies.first_rank,
                         "this point is not in exactly those tiles that show its region"};
  return std::nullopt;
}

}  // namespace capcon
