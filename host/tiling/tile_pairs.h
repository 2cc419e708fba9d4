#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// Whether tile u can stand at (dx, dy) from tile t as far as the vertices that they share say.
bool can_stand(std::uint32_t colours, std::uint32_t t, std::uint32_t u, int dx, int dy);

/// The numbers of the tiles that a set has, in order.
std::vector<std::uint32_t> tile_numbers(const TileSet& set);

/// How often tiles of a set meet. Tiles are counted from 0 in the order of tile_numbers.
class TilePairs {
 public:
  /// `one_tile_weight`: how much the one-tile tilings count beside the infinite random tiling's 1. Bounded
  /// sets have none.
  TilePairs(const TileSet& set, double one_tile_weight);

  /// [t * tiles + u]: the chance that some cell holds t and the one (dx, dy) from it u, times the number of
  /// tiles. Exact for complete sets; for compact ones counted in a tiling of 256 x 256 tiles; for bounded
  /// ones counted in random tilings of 2 x 2, 3 x 3, 4 x 4 and 8 x 8 tiles, which count alike.
  const std::vector<double>& at(int dx, int dy);

 private:
  std::vector<double> exact(int dx, int dy) const;
  std::vector<double> counted(int dx, int dy) const;
  void draw(const TileSet& set, std::uint32_t side, double weight, std::uint64_t seed);

  std::uint32_t colours_;
  double one_tile_weight_;
  std::vector<std::uint32_t> numbers_;
  /// The tile of every cell of a random tiling, and how much a cell counts.
  struct Drawn {
    std::uint32_t side = 1;
    double weight = 1;
    std::vector<std::uint32_t> tiles;
  };
  std::vector<Drawn> drawn_;  ///< none for a complete set
  bool bounded_;
  std::map<std::pair<int, int>, std::vector<double>> by_shift_;
};

}  // namespace capcon
