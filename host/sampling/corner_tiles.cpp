#include <fmt/format.h>

#include "base/error.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/parts_store.h"
#include "sampling/samplers.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

// In the second word: points come in the order that the table says.
constexpr std::uint32_t kDealt = 0x80000000u;

class CornerTileSampler final : public Sampler {
 public:
  CornerTileSampler(const TileSet& set, std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : CornerTileSampler(set, choose_cut(count, set.points_per_tile), count, seed, parts) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    const FixedPoint p = whole_ ? places_[std::size_t(colouring(pixel, dimension)) * count() + index]
                                : place(pixel, index, dimension);
    return {p.x + words[0], p.y + words[1]};
  }

  /// Texels. Whole tilings: their points. Else first the cells (origin x, y; corners 0 and 1, corners 2 and 3
  /// as 16-bit pairs), then the tiles' points, and for parts the order, four words a texel.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    SamplerTables result{layout::kSamplerCapcon, {tiling_.size(), cells_.ranks, 0, cells_.extra}, {}};
    if (whole_) {
      result.constants = {tiling_.size(), 0, 0, 0};
    } else {
      if (!order_.empty()) result.constants[1] |= kDealt;
      for (const std::uint32_t cell : cells_.cells) {
        const FixedPoint origin = tiling_.origin(cell);
        const auto c = tiling_.corners(cell);
        result.texels.emplace_back(origin.x, origin.y, c[0] | c[1] << 16, c[2] | c[3] << 16);
      }
    }
    for (const FixedPoint p : places_) result.texels.emplace_back(p.x, p.y, 0, 0);
    const auto word = [&](std::size_t i) { return i < order_.size() ? order_[i] : 0; };
    for (std::size_t i = 0; i < order_.size(); i += 4)
      result.texels.emplace_back(word(i), word(i + 1), word(i + 2), word(i + 3));
    return result;
  }

 protected:
  bool is_stored_by_place() const override { return true; }

 private:
  CornerTileSampler(const TileSet& set, const TilingCut& cut, std::uint32_t count, std::uint32_t seed,
                    std::uint32_t parts)
      : Sampler("capcon", count, seed, parts),
        tiling_(cut.a, cut.b),
        cells_(cell_points(cut, tiling_)),
        whole_(parts > 1 && has_whole_tilings(tiling_)) {
    TilingParts dealt;
    if (parts > 1) dealt = shipped_or_made_parts(set, tiling_, cells_, parts);
    if (whole_) {
      for (std::uint32_t colouring = 0; colouring < dealt.orders.size(); ++colouring) {
        const std::vector<FixedPoint> points = whole_tiling(set, tiling_, cells_, colouring);
        for (const std::uint32_t number : dealt.orders[colouring]) places_.push_back(points[number]);
      }
      return;
    }
    for (std::uint32_t i = 0; parts > 1 && i < count; ++i) {
      const CellPoints::Where at = cells_.where(dealt.orders[0][i]);
      order_.push_back(at.place | at.rank << 16);
    }
    for (std::size_t t = 0; t < set.tiles.size(); ++t) {
      for (std::uint32_t s = 0; s < cells_.most(); ++s) {
        const std::uint32_t rank = parts > 1 ? dealt.rank[t][s] : s;
        places_.push_back(tiling_.place(set.tiles[t][rank].position));
      }
    }
  }

  /// The colours of the first vertices, one bit each.
  std::uint32_t colouring(std::uint32_t pixel, std::uint32_t dimension) const {
    return set_words(seed(), pixel, dimension, kPurposeColours)[0] & ((1u << tiling_.size()) - 1);
  }

  /// On the torus, not shifted yet.
  FixedPoint place(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
    const CellPoints::Where at =
        order_.empty() ? cells_.where(index) : CellPoints::Where{order_[index] & 0xffff, order_[index] >> 16};
    const std::uint32_t cell = cells_.cells[at.place];
    const auto corners = tiling_.corners(cell);
    std::uint32_t tile = 0;
    for (int corner = 0; corner < 4; ++corner) tile |= colour(pixel, dimension, corners[corner]) << corner;
    const FixedPoint origin = tiling_.origin(cell);
    const FixedPoint place = places_[tile * cells_.most() + at.rank];
    return {origin.x + place.x, origin.y + place.y};
  }

  std::uint32_t colour(std::uint32_t pixel, std::uint32_t dimension, std::uint32_t vertex) const {
    const auto words = set_words(seed(), pixel, dimension, kPurposeColours + (vertex >> 7));
    return (words[(vertex >> 5) & 3] >> (vertex & 31)) & 1;
  }

  GaussianTiling tiling_;
  CellPoints cells_;
  bool whole_;
  std::vector<FixedPoint> places_;    ///< of whole tilings on the torus; else of the tiles' slots
  std::vector<std::uint32_t> order_;  ///< of parts: place of the cell | slot << 16
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
