#include "tiling/tile_pairs.h"

#include <algorithm>

#include "tiling/region_layout.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

constexpr std::uint32_t kCountSide = 256;
constexpr std::uint32_t kBoundedSides[] = {2, 3, 4, 8}, kBoundedCells = 4096;
constexpr std::uint64_t kCountSeed = 0x72616e6b;

}  // namespace

bool can_stand(std::uint32_t colours, std::uint32_t t, std::uint32_t u, int dx, int dy) {
  const auto a = tile_colours(colours, t), b = tile_colours(colours, u);
  for (int corner = 0; corner < 4; ++corner) {
    const int x = (corner & 1) - dx, y = (corner >> 1) - dy;  // the same vertex seen from u
    if (x >= 0 && x <= 1 && y >= 0 && y <= 1 && a[corner] != b[x + 2 * y]) return false;
  }
  return true;
}

std::vector<std::uint32_t> tile_numbers(const TileSet& set) {
  return tile_numbers(set.colours, set.colouring);
}

TilePairs::TilePairs(const TileSet& set, double one_tile_weight)
    : colours_(set.colours),
      one_tile_weight_(one_tile_weight),
      numbers_(tile_numbers(set)),
      bounded_(set.colouring == Colouring::bounded) {
  if (set.colouring == Colouring::apart) draw(set, kCountSide, 1.0 / (kCountSide * kCountSide), kCountSeed);
  if (!bounded_) return;
  for (const std::uint32_t side : kBoundedSides) {
    const std::uint32_t tilings = kBoundedCells / (side * side);
    for (std::uint32_t i = 0; i < tilings; ++i)
      draw(set, side, 1.0 / (tilings * side * side * double(std::size(kBoundedSides))), kCountSeed + i);
  }
}

void TilePairs::draw(const TileSet& set, std::uint32_t side, double weight, std::uint64_t seed) {
  const GaussianTiling tiling(side, 0);
  const auto colours = random_colours(tiling, set, seed);
  Drawn drawn{side, weight, {}};
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
    const std::uint32_t tile = tile_of(tiling, colours, set.colours, cell);
    drawn.tiles.push_back(std::uint32_t(std::ranges::lower_bound(numbers_, tile) - numbers_.begin()));
  }
  drawn_.push_back(std::move(drawn));
}

std::vector<double> TilePairs::exact(int dx, int dy) const {
  const std::size_t tiles = numbers_.size();
  std::vector<double> weights(tiles * tiles, 0.0);
  double consistent = 0;
  for (std::size_t t = 0; t < tiles; ++t)
    for (std::size_t u = 0; u < tiles; ++u)
      if (can_stand(colours_, numbers_[t], numbers_[u], dx, dy)) weights[t * tiles + u] = 1, ++consistent;
  for (double& w : weights) w *= double(tiles) / consistent;
  return weights;
}

std::vector<double> TilePairs::counted(int dx, int dy) const {
  const std::size_t tiles = numbers_.size();
  std::vector<double> weights(tiles * tiles, 0.0);
  for (const Drawn& drawn : drawn_) {
    const GaussianTiling tiling(drawn.side, 0);
    for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
      const glm::ivec2 there = tiling.cell(cell) + glm::ivec2(dx, dy);
      const bool beyond = std::min(there.x, there.y) < 0 || std::max(there.x, there.y) >= int(drawn.side);
      if (bounded_ && beyond) continue;
      weights[drawn.tiles[cell] * tiles + drawn.tiles[tiling.index(there.x, there.y)]] +=
          double(tiles) * drawn.weight;
    }
  }
  return weights;
}

const std::vector<double>& TilePairs::at(int dx, int dy) {
  auto [entry, is_new] = by_shift_.try_emplace({dx, dy});
  if (!is_new) return entry->second;
  std::vector<double> weights = drawn_.empty() ? exact(dx, dy) : counted(dx, dy);
  const std::size_t tiles = numbers_.size();
  std::vector<std::size_t> alone;  // the tiles with four equal corners tile a torus of one tile
  for (std::size_t t = 0; t < tiles && !bounded_; ++t) {
    const auto c = tile_colours(colours_, numbers_[t]);
    if (c[0] == c[1] && c[0] == c[2] && c[0] == c[3]) alone.push_back(t);
  }
  for (const std::size_t t : alone)
    weights[t * tiles + t] += one_tile_weight_ * double(tiles) / double(alone.size());
  return entry->second = std::move(weights);
}

}  // namespace capcon
