#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/hash.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

/// How a set of n points is cut into tiles: a^2 + b^2 tiles with the first `ranks` points each, `extra` tiles
/// one more.
struct Cut {
  std::uint32_t a = 1, b = 0, ranks = 1, extra = 0;
};

/// The cut with the fewest left-over points, then the one that uses most of each tile; n <= tile points: one
/// tile.
Cut choose_cut(std::uint32_t n, std::uint32_t tile_points) {
  if (n <= tile_points) return {1, 0, n, 0};
  std::optional<Cut> best;
  const auto limit = static_cast<std::uint32_t>(std::sqrt(2.0 * n / tile_points)) + 3;
  for (std::uint32_t a = 1; a <= limit; ++a) {
    for (std::uint32_t b = 0; b <= a; ++b) {
      const std::uint32_t tiles = a * a + b * b;
      const Cut cut{a, b, n / tiles, n % tiles};
      const bool fits = cut.ranks + (cut.extra > 0 ? 1 : 0) <= tile_points && 2 * cut.ranks >= tile_points;
      if (!fits) continue;
      const auto key = [](const Cut& c) {
        return std::pair(c.extra > 0 ? 1 : 0, -static_cast<int>(c.ranks));
      };
      if (!best || key(cut) < key(*best)) best = cut;
    }
  }
  return best.value();
}

class CornerTileSampler final : public Sampler {
 public:
  CornerTileSampler(const TileSet& set, std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("capcon", count, seed, parts),
        cut_(choose_cut(count, set.points_per_tile)),
        tiling_(cut_.a, cut_.b) {
    const std::uint32_t stored = cut_.ranks + (cut_.extra > 0 ? 1 : 0);
    for (const auto& tile : set.tiles) {
      for (std::uint32_t r = 0; r < stored; ++r) places_.push_back(tiling_.place(tile[r].position));
    }
    // Tiles with an extra point come first: in an order by hash, so that they do not lie side by side.
    cells_.resize(tiling_.size());
    std::iota(cells_.begin(), cells_.end(), 0u);
    if (cut_.extra > 0) {
      std::sort(cells_.begin(), cells_.end(),
                [](std::uint32_t x, std::uint32_t y) { return mix64(0, 0, x) < mix64(0, 0, y); });
    }
  }

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    const std::uint32_t longer = cut_.extra * (cut_.ranks + 1);
    const bool in_longer = index < longer;
    const std::uint32_t from = in_longer ? index : index - longer;
    const std::uint32_t length = cut_.ranks + (in_longer ? 1 : 0);
    const std::uint32_t cell = cells_[from / length + (in_longer ? 0 : cut_.extra)];
    const auto corners = tiling_.corners(cell);
    std::uint32_t tile = 0;
    for (int corner = 0; corner < 4; ++corner) tile |= colour(pixel, dimension, corners[corner]) << corner;
    const std::uint32_t stored = cut_.ranks + (cut_.extra > 0 ? 1 : 0);
    const FixedPoint origin = tiling_.origin(cell);
    const FixedPoint place = places_[tile * stored + from % length];
    return {origin.x + place.x + words[0], origin.y + place.y + words[1]};
  }

  /// Texels: first the cells (origin x, y; corners 0 and 1, corners 2 and 3 as 16-bit pairs), then the tiles'
  /// points.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    SamplerTables result{layout::kSamplerCapcon, {tiling_.size(), cut_.ranks, 0, cut_.extra}, {}};
    for (const std::uint32_t cell : cells_) {
      const FixedPoint origin = tiling_.origin(cell);
      const auto c = tiling_.corners(cell);
      result.texels.emplace_back(origin.x, origin.y, c[0] | c[1] << 16, c[2] | c[3] << 16);
    }
    for (const FixedPoint p : places_) result.texels.emplace_back(p.x, p.y, 0, 0);
    return result;
  }

 private:
  std::uint32_t colour(std::uint32_t pixel, std::uint32_t dimension, std::uint32_t vertex) const {
    const auto words = set_words(seed(), pixel, dimension, kPurposeColours + (vertex >> 7));
    return (words[(vertex >> 5) & 3] >> (vertex & 31)) & 1;
  }

  Cut cut_;
  GaussianTiling tiling_;
  std::vector<std::uint32_t> cells_;
  std::vector<FixedPoint> places_;
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts) {
  // The table holds lattice vertices as 16-bit numbers: 65,536 tiles of 16 points at the most.
  constexpr std::uint32_t kMostPoints = 1u << 20;
  if (count > kMostPoints) {
    throw InputError(fmt::format(
        "the capcon sampler makes sets of at most {} points, and {} are asked for; take fewer samples, or "
        "sobol-owen",
        kMostPoints, count));
  }
  return std::make_unique<CornerTileSampler>(shipped_tile_set(2, 16), count, seed, parts);
}

}  // namespace capcon
