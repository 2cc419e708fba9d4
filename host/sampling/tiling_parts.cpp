#include "sampling/tiling_parts.h"

#include <algorithm>
#include <numeric>

#include "base/morton.h"
#include "base/parallel.h"
#include "points/spread_partition.h"
#include "tiling/tile_labels.h"
#include "tiling/tile_slots.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

constexpr std::uint64_t kPartitionSeed = 1;
// With parts, and at most this many tiles, all tilings are stored whole: 32 of at most 80 points.
constexpr std::uint32_t kWholeTiles = 5;

/// Indices of the points part by part, in Morton order within a part.
std::vector<std::uint32_t> part_order(const std::vector<FixedPoint>& places, std::uint32_t parts) {
  Points points;
  for (const FixedPoint p : places) points.push_back(to_double(p));
  const auto labels = spread_partition(points, {parts, kPartitionSeed});
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::pair(labels[i], morton_code(places[i].x, places[i].y));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return order;
}

/// The cells in an order in which neighbours lie close, as places in CellPoints::cells.
std::vector<std::uint32_t> near_order(const GaussianTiling& tiling, const CellPoints& points) {
  std::vector<std::uint32_t> order(points.cells.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto code = [&](std::uint32_t i) {
    const FixedPoint p = tiling.origin(points.cells[i]);
    return morton_code(p.x, p.y);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return code(a) < code(b); });
  return order;
}

/// As many points in every tile, which `parts` divides: a part is what bears its label.
TilingParts deal_by_labels(TileSet set, const GaussianTiling& tiling, const CellPoints& points,
                           std::uint32_t parts) {
  set.points_per_tile = points.ranks;
  for (auto& tile : set.tiles) tile.resize(std::min<std::size_t>(tile.size(), points.ranks));
  const TileLabels labels = label_parts(set, parts);
  TilingParts result;
  for (std::size_t t = 0; t < labels.size(); ++t) {
    auto& ranks = result.rank.emplace_back(labels[t].size());
    std::iota(ranks.begin(), ranks.end(), 0u);
    const auto key = [&](std::uint32_t r) {
      const FixedPoint p = set.tiles[t][r].position;
      return std::pair(labels[t][r], morton_code(p.x, p.y));
    };
    std::sort(ranks.begin(), ranks.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  }
  const std::uint32_t slots = points.ranks / parts;
  auto& order = result.orders.emplace_back();
  for (std::uint32_t p = 0; p < parts; ++p) {
    for (const std::uint32_t i : near_order(tiling, points))
      for (std::uint32_t s = 0; s < slots; ++s) order.push_back(i * points.ranks + p * slots + s);
  }
  return result;
}

/// Every colouring's own partition.
TilingParts partition_tilings(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                              std::uint32_t parts) {
  TilingParts result;
  result.orders.resize(std::size_t(1) << tiling.size());
  parallel_for(result.orders.size(), [&](std::size_t colouring) {
    result.orders[colouring] = part_order(whole_tiling(set, tiling, points, std::uint32_t(colouring)), parts);
  });
  return result;
}

}  // namespace

bool has_whole_tilings(const GaussianTiling& tiling) {
  return tiling.size() <= kWholeTiles;
}

std::vector<FixedPoint> whole_tiling(const TileSet& set, const GaussianTiling& tiling,
                                     const CellPoints& points, std::uint32_t colouring) {
  std::vector<std::uint32_t> colours(tiling.size());
  for (std::uint32_t v = 0; v < colours.size(); ++v) colours[v] = (colouring >> v) & 1;
  std::vector<FixedPoint> places;
  for (std::size_t i = 0; i < points.cells.size(); ++i) {
    const std::uint32_t cell = points.cells[i];
    const auto& tile = set.tiles[tile_of(tiling, colours, set.colours, cell)];
    for (std::uint32_t r = 0; r < points.points_in(i); ++r) {
      const FixedPoint origin = tiling.origin(cell), place = tiling.place(tile[r].position);
      places.push_back({origin.x + place.x, origin.y + place.y});
    }
  }
  return places;
}

TilingParts make_tiling_parts(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                              std::uint32_t parts) {
  if (has_whole_tilings(tiling) && !set.bounded()) return partition_tilings(set, tiling, points, parts);
  // One point of a part a tile would leave it near a lattice: half as much again error at edges along it.
  if (points.extra == 0 && points.ranks % parts == 0 && points.ranks > parts)
    return deal_by_labels(set, tiling, points, parts);
  // Where a cell has a point more than others, that is its last slot.
  TileSlots slots = match_slots(set, points.ranks);
  if (points.extra > 0) {
    glm::dvec2 sum(0);
    double tiles = 0;
    for (std::size_t t = 0; t < slots.rank.size(); ++t) {
      if (slots.rank[t].empty()) continue;
      slots.rank[t].push_back(points.ranks);
      sum += to_double(set.tiles[t][points.ranks].position);
      ++tiles;
    }
    slots.place.push_back(sum / tiles);
  }
  std::vector<FixedPoint> places;
  for (std::uint32_t i = 0; i < points.cells.size(); ++i) {
    const FixedPoint origin = tiling.origin(points.cells[i]);
    for (std::uint32_t s = 0; s < points.points_in(i); ++s) {
      const FixedPoint place = tiling.place(to_fixed(slots.place[s]));
      places.push_back({origin.x + place.x, origin.y + place.y});
    }
  }
  return {std::move(slots.rank), {part_order(places, parts)}};
}

}  // namespace capcon
