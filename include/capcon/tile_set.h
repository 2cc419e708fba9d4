#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "capcon/point.h"

namespace capcon::sampling {

/// A set of corner tiles (docs/tiles.md): any arrangement of its tiles whose corners agree in colour is well
/// spread across the seams. Points of a tile are ranked: any number of first ranks of all tiles is well
/// spread.
class TileSet {
 public:
  /// `file`: a capcon-tiles file (docs/tile-format.md), or the name of a shipped set, such as "c2n16": 2
  /// colours, 16 points a tile. Throws std::runtime_error with one sentence (file:line) for what is no such
  /// file.
  explicit TileSet(const std::string& file = "c2n16", const std::string& data = shipped_data());
  TileSet(TileSet&&) noexcept;
  TileSet& operator=(TileSet&&) noexcept;
  ~TileSet();

  std::uint32_t colours() const;
  std::uint32_t points_per_tile() const;
  /// Numbers of tiles are below this, colours()^4; those that a compact set does without have no points.
  std::uint32_t tiles() const;
  /// The number of the tile with these colours, each below colours(), at its corners (0,0), (1,0), (0,1) and
  /// (1,1).
  std::uint32_t tile(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01, std::uint32_t c11) const;
  /// Its points in its own unit square, by rank.
  std::vector<Point> points(std::uint32_t tile) const;

  /// A stochastic tiling of the torus by side x side tiles, 1 <= side <= 256, whose corners are coloured by
  /// hash of the seed: side^2 * ranks points, tile by tile, rows first. ranks = 0: all of them. Throws
  /// std::runtime_error for more ranks than there are.
  std::vector<Point> tiling(std::uint32_t side, std::uint64_t seed = 1, std::uint32_t ranks = 0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace capcon::sampling
