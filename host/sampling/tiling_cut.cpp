#include "sampling/tiling_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/hash.h"

namespace capcon {

TilingCut choose_cut(std::uint32_t n, std::uint32_t tile_points) {
  if (n <= tile_points) return {1, 0, n, 0};
  std::optional<TilingCut> best;
  const auto limit = static_cast<std::uint32_t>(std::sqrt(2.0 * n / tile_points)) + 3;
  for (std::uint32_t a = 1; a <= limit; ++a) {
    for (std::uint32_t b = 0; b <= a; ++b) {
      const std::uint32_t tiles = a * a + b * b;
      const TilingCut cut{a, b, n / tiles, n % tiles};
      const bool fits = cut.ranks + (cut.extra > 0 ? 1 : 0) <= tile_points && 2 * cut.ranks >= tile_points;
      if (!fits) continue;
      const auto key = [](const TilingCut& c) {
        return std::pair(c.extra > 0 ? 1 : 0, -static_cast<int>(c.ranks));
      };
      if (!best || key(cut) < key(*best)) best = cut;
    }
  }
  return best.value();
}

CellPoints::Where CellPoints::where(std::uint32_t number) const {
  const std::uint32_t longer = extra * (ranks + 1);
  const bool in_longer = number < longer;
  const std::uint32_t from = in_longer ? number : number - longer, length = ranks + (in_longer ? 1 : 0);
  return {from / length + (in_longer ? 0 : extra), from % length};
}

CellPoints cell_points(const TilingCut& cut, const GaussianTiling& tiling) {
  CellPoints points{std::vector<std::uint32_t>(tiling.size()), cut.ranks, cut.extra};
  std::iota(points.cells.begin(), points.cells.end(), 0u);
  if (cut.extra > 0) {
    std::sort(points.cells.begin(), points.cells.end(),
              [](std::uint32_t x, std::uint32_t y) { return mix64(0, 0, x) < mix64(0, 0, y); });
  }
  return points;
}

}  // namespace capcon
