#include "tiling/tied_points.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "tiling/region_layout.h"

namespace capcon {
namespace {

constexpr RegionKind kKinds[] = {RegionKind::corner, RegionKind::horizontal_edge, RegionKind::vertical_edge,
                                 RegionKind::interior};

constexpr std::uint64_t kCandidates = 8;

struct Box {
  glm::dvec2 low, high;
};

// Where the points of a region's part start: rectangles with as much area as they have points.
Box start_box(RegionKind kind, std::uint32_t part, RegionCounts counts, std::uint32_t n) {
  const double h = std::sqrt(double(counts.corner) / n), depth = counts.edge_side / (n * (1 - 2 * h));
  const glm::dvec2 at(part & 1, part >> 1);
  switch (kind) {
    case RegionKind::corner:
      return {at * (1 - h), at * (1 - h) + h};
    case RegionKind::horizontal_edge:
      return {{h, part * (1 - depth)}, {1 - h, part * (1 - depth) + depth}};
    case RegionKind::vertical_edge:
      return {{part * (1 - depth), h}, {part * (1 - depth) + depth, 1 - h}};
    default:
      return {glm::dvec2(depth), glm::dvec2(1 - depth)};
  }
}

// Of some random places the one that is farthest from the points that its tiles have already (Mitchell 1991).
void place_apart(TiedPoints& points, std::uint32_t index, Box box, std::uint64_t seed) {
  double farthest = -1;
  glm::dvec2 best(0);
  for (std::uint64_t k = 0; k < kCandidates; ++k) {
    const glm::dvec2 u(uniform64(seed, index, 2 * k), uniform64(seed, index, 2 * k + 1));
    const glm::dvec2 place = box.low + u * (box.high - box.low);
    double nearest = 1;
    for (const auto& tile : points.tiles)
      if (!tile.empty() && tile.back() == index)
        for (std::size_t i = 0; i + 1 < tile.size(); ++i) {
          glm::dvec2 d = place - points.free[tile[i]].position;
          d -= glm::floor(d + 0.5);
          nearest = std::min(nearest, glm::dot(d, d));
        }
    if (nearest > farthest) farthest = nearest, best = place;
  }
  points.free[index].position = best;
}

std::uint32_t power(std::uint32_t base, std::uint32_t exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace

RegionCounts region_counts(std::uint32_t points_per_tile) {
  if (points_per_tile < 9)
    throw InputError("a tile needs at least 9 points, so that some are left for its interior");
  const auto side = std::uint32_t(std::floor(std::sqrt(double(points_per_tile))));
  return {1, side - 2, points_per_tile - 4 * (side - 1)};
}

TiedPoints random_tied_points(std::uint32_t colours, std::uint32_t points_per_tile, RegionCounts counts,
                              std::uint64_t seed, Colouring colouring) {
  TiedPoints result{colours, points_per_tile, {}, {}, colouring};
  result.tiles.resize(tile_count(colours));
  const std::vector<std::uint32_t> numbers = tile_numbers(colours, colouring);
  const std::vector<double> shares = tile_shares(colours, colouring);
  for (const RegionKind kind : kKinds) {
    const std::uint32_t bound = kind == RegionKind::corner ? 1 : kind == RegionKind::interior ? 4 : 2;
    const std::uint32_t regions =
        power(colours, bound);  // as many corner colours tell regions of this kind apart
    const std::uint32_t per_part = kind == RegionKind::corner     ? counts.corner
                                   : kind == RegionKind::interior ? counts.interior
                                                                  : counts.edge_side;
    for (std::uint32_t region = 0; region < regions; ++region)
      for (std::uint32_t slot = 0; slot < per_part * part_count(kind); ++slot) {
        const std::uint32_t part = slot / per_part;
        const Box box = start_box(kind, part, counts, points_per_tile);
        const std::uint64_t stream = result.free.size();
        double share = 0;
        bool shown = false;
        for (const std::uint32_t t : numbers)
          if (tile_region(colours, t, kind, part) == region) {
            result.tiles[t].push_back(std::uint32_t(stream));
            share += shares[t];
            shown = true;
          }
        if (!shown) continue;  // an edge or a tile that a compact set does without
        if (colouring == Colouring::free) share = 1.0 / regions;  // without the sum's rounding
        result.free.push_back({kind, region, part, slot, share, {}});
        place_apart(result, std::uint32_t(stream), box, seed);
      }
  }
  return result;
}

TileSet to_tile_set(const TiedPoints& points, std::string recipe) {
  TileSet set{points.colours, points.points_per_tile, std::move(recipe), {}, points.colouring};
  for (const std::vector<std::uint32_t>& tile : points.tiles) {
    set.tiles.emplace_back();
    for (const std::uint32_t i : tile) {
      const TiedPoints::FreePoint& p = points.free[i];
      set.tiles.back().push_back({to_fixed(p.position), p.kind, p.region, p.slot});
    }
  }
  return set;
}

}  // namespace capcon
