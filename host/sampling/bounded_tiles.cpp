#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "base/morton.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"
#include "sampling/tiling_parts.h"
#include "tiling/even_cells.h"
#include "tiling/region_layout.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

constexpr std::uint32_t kOutside = 0xffffu;  // in place of a vertex' number
// In the second word: points come in the order that the table says.
constexpr std::uint32_t kDealt = 0x80000000u;
constexpr std::uint32_t kMostSide = 256;  // the table holds vertices and cells as 16-bit numbers

/// The cells of the tiling, in an order in which neighbours lie close.
CellPoints near_cells(std::uint32_t side, std::uint32_t ranks) {
  CellPoints points{{}, ranks, 0};
  for (std::uint32_t cell = 0; cell < side * side; ++cell) points.cells.push_back(cell);
  std::ranges::sort(points.cells, {},
                    [&](std::uint32_t cell) { return morton_code(cell % side, cell / side); });
  return points;
}

/// Stochastic tilings of the unit square by k x k tiles of a bounded set, a random point in the cell of every
/// point (even_cells.h), under one of the square's eight symmetries.
class BoundedTileSampler final : public Sampler {
 public:
  BoundedTileSampler(const TileSet& set, std::uint32_t side, std::uint32_t seed, std::uint32_t parts)
      : Sampler("capcon-bounded", side * side * set.points_per_tile, seed, parts),
        ranks_(set.points_per_tile),
        outside_(set.colours - 1) {
    const GaussianTiling tiling(side, 0);
    const CellPoints cells = near_cells(side, ranks_);
    TilingParts dealt;
    if (parts > 1) dealt = make_tiling_parts(set, tiling, cells, parts);
    for (const std::uint32_t cell : cells.cells) {
      const glm::uvec2 at(cell % side, cell / side);
      const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
        const bool inside = x > 0 && y > 0 && x < side && y < side;
        return inside ? (x - 1) + (side - 1) * (y - 1) : kOutside;
      };
      const FixedPoint origin = tiling.origin(cell);
      cells_.emplace_back(origin.x, origin.y, vertex(at.x, at.y) | vertex(at.x + 1, at.y) << 16,
                          vertex(at.x, at.y + 1) | vertex(at.x + 1, at.y + 1) << 16);
    }
    const EvenCells even(set.colours, ranks_);
    places_.resize(set.tiles.size() * ranks_);
    for (std::uint32_t t = 0; t < set.tiles.size(); ++t)
      for (std::uint32_t s = 0; s < ranks_ && !set.tiles[t].empty(); ++s) {
        const std::uint32_t rank = parts > 1 ? dealt.rank[t][s] : s;
        places_[t * ranks_ + s] = texel(even.cell(t, to_double(set.tiles[t][rank].position)), side);
      }
    if (parts == 1) return;
    for (const std::uint32_t number : dealt.orders[0]) {
      const CellPoints::Where at = cells.where(number);
      order_.push_back(at.place | at.rank << 16);
    }
  }

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    std::uint32_t place_in_order = index;
    if (!order_.empty()) {
      place_in_order = turned(pixel, index, dimension);
      const std::uint32_t word = order_[place_in_order];
      index = (word & 0xffff) * ranks_ + (word >> 16);
    }
    const glm::uvec4 cell = cells_[index / ranks_];
    std::uint32_t tile = 0, digit = 1;
    for (const std::uint32_t vertex : {cell.z & 0xffff, cell.z >> 16, cell.w & 0xffff, cell.w >> 16}) {
      tile += digit * colour(pixel, dimension, vertex);
      digit *= outside_ + 1;
    }
    const glm::uvec4 place = places_[tile * ranks_ + index % ranks_];
    // Where in its cell: an Owen-scrambled net over the order of the set or its parts, so that neighbours'
    // places in their cells balance. Each is uniform, which is all that unbiasedness needs.
    const auto within = set_words(seed(), pixel, dimension, kPurposeWithin);
    const std::uint32_t u = reverse_bits(owen_scramble_reversed(place_in_order, within[2])),
                        v = reverse_bits(
                            owen_scramble_reversed(sobol_second_reversed(place_in_order), within[3]));
    const std::uint32_t width = place.z & ~3u, across = multiply_high(u, width);
    FixedPoint p{cell.x + place.x + across, cell.y + place.y + multiply_high(v, place.w)};
    if ((place.z & 3) != 0 && across >= width >> 1) p.y += (place.z & 1) != 0 ? place.w : 0u - place.w;
    const std::uint32_t turn = set_words(seed(), pixel, dimension)[1];
    p = {turn & 1 ? ~p.x : p.x, turn & 2 ? ~p.y : p.y};
    if (turn & 4) std::swap(p.x, p.y);
    return p;
  }

  /// Texels: the tiling's cells (origin x, y; corners 0 and 1, corners 2 and 3 as 16-bit pairs, kOutside
  /// outside), then the cells of the tiles' points, and for parts the order, four words a texel.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    SamplerTables result{layout::kSamplerCapconBounded,
                         {std::uint32_t(cells_.size()), ranks_ | (order_.empty() ? 0 : kDealt), 0,
                          outside_ | split().parts << 8},
                         cells_};
    result.texels.insert(result.texels.end(), places_.begin(), places_.end());
    const auto word = [&](std::size_t i) { return i < order_.size() ? order_[i] : 0; };
    for (std::size_t i = 0; i < order_.size(); i += 4)
      result.texels.emplace_back(word(i), word(i + 1), word(i + 2), word(i + 3));
    return result;
  }

 protected:
  bool is_stored_by_place() const override { return true; }

 private:
  /// Low corner and size in a tile of the k x k; the lowest bits of the width: 1 a twin above, 2 below.
  static glm::uvec4 texel(const EvenCells::Cell& cell, std::uint32_t side) {
    const auto fixed = [&](double v) { return std::uint32_t(std::floor(v * 0x1p32 / side)); };
    const glm::dvec2 high = cell.low + cell.size;
    const glm::uvec2 low(fixed(cell.low.x), fixed(cell.low.y));
    const std::uint32_t twin = cell.twin > 0 ? 1 : cell.twin < 0 ? 2 : 0;
    return {low.x, low.y, ((fixed(high.x) - low.x) & ~3u) | twin, fixed(high.y) - low.y};
  }

  std::uint32_t colour(std::uint32_t pixel, std::uint32_t dimension, std::uint32_t vertex) const {
    if (vertex == kOutside) return outside_;
    const auto words = set_words(seed(), pixel, dimension, kPurposeColours + (vertex >> 7));
    return (words[(vertex >> 5) & 3] >> (vertex & 31)) & 1;
  }

  /// A part alone leaves out most cells of its set: which part comes first is random, so that each is
  /// unbiased.
  std::uint32_t turned(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
    const auto turn = set_words(seed(), pixel, dimension, kPurposeParts)[3];
    const std::uint32_t place = index + split().points * multiply_high(turn, split().parts);
    return place >= count() ? place - count() : place;
  }

  std::uint32_t ranks_, outside_;
  std::vector<glm::uvec4> cells_, places_;
  std::vector<std::uint32_t> order_;  ///< of parts: place of the cell | slot << 16
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_bounded_sampler(std::uint32_t count, std::uint32_t seed,
                                                     std::uint32_t parts) {
  const TileSet set = shipped_tile_set("c2n16-bounded");
  const std::uint32_t n = set.points_per_tile;
  const auto side = std::uint32_t(std::lround(std::sqrt(double(count) / n)));
  if (side < kLeastBoundedSide || side > kMostSide || std::uint64_t(side) * side * n != count) {
    const std::uint32_t near = std::clamp(side, kLeastBoundedSide, kMostSide);
    throw InputError(fmt::format(
        "the capcon-bounded sampler makes sets of {} k^2 points, k 2 to {}, and {} are asked for; "
        "take {}, or capcon-domain",
        n, kMostSide, count, near * near * n));
  }
  if (set.colours != 3 || !set.bounded() || find_shared_cell(set))
    throw InputError(
        "tiles/c2n16-bounded.tiles: the capcon-bounded sampler needs a set of two colours inside whose "
        "points "
        "have a cell each; make it again with the command in its fourth line");
  return std::make_unique<BoundedTileSampler>(set, side, seed, parts);
}

}  // namespace capcon
