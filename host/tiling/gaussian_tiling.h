#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "tiling/fixed_point.h"

namespace capcon {

/// A stochastic tiling of the unit torus by N = a^2 + b^2 equal squares: the lattice of Gaussian integers
/// modulo a + bi, turned and scaled onto the torus by 1 / (a + bi). b = 0 is the usual a x a tiling; a = b
/// gives 2 a^2 tiles turned by 45 degrees, so that every power of two is a number of tiles. No tile is
/// stored: the colour of a lattice vertex is a hash of its index, and a cell's tile follows from its four
/// vertices.
class GaussianTiling {
 public:
  /// 1 <= a <= 32767, 0 <= b <= a.
  GaussianTiling(std::uint32_t a, std::uint32_t b);

  /// The number of tiles, which is also the number of lattice vertices.
  std::uint32_t size() const { return size_; }
  /// Tiles along the side of an a x a tiling; 0 for b > 0, which turns it.
  std::uint32_t side() const { return b_ == 0 ? std::uint32_t(a_) : 0; }
  /// Index in [0, size) of the vertex or cell at the integers (x, y), wrapped.
  std::uint32_t index(std::int64_t x, std::int64_t y) const;
  /// The integers (x, y) of a vertex or cell index: the representative with 0 <= y < gcd(a, b), 0 <= x < N /
  /// gcd.
  glm::ivec2 cell(std::uint32_t index) const;
  /// Vertex indices of a cell's corners (0,0), (1,0), (0,1), (1,1).
  std::array<std::uint32_t, 4> corners(std::uint32_t cell) const;
  /// Place on the torus of the cell's lower left vertex, exact to 2^-32.
  FixedPoint origin(std::uint32_t cell) const;
  /// A tile's point, turned and scaled by 1 / (a + bi), still to be added to a cell's origin.
  FixedPoint place(FixedPoint tile_point) const;

 private:
  std::int64_t a_, b_;
  std::uint32_t size_, gcd_;
  std::int64_t shift_;  ///< the lattice's basis is (size / gcd, 0) and (shift, gcd)
};

}  // namespace capcon
