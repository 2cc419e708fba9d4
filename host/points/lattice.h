#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_int2_sized.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// A point of the torus in units of 2^-32: differences wrap around by themselves and are exact.
struct TorusPoint {
  std::uint32_t x, y;
};

/// A lattice on the torus: m points that are all alike.
struct EvenLattice {
  std::uint64_t m = 1;
  glm::dvec2 a{1, 0}, b{0, 1};  ///< its two shortest vectors, units of the torus

  /// The lattice with four points for one, of the same shape.
  EvenLattice halved() const { return {4 * m, 0.5 * a, 0.5 * b}; }
};

/// The rank-1 lattice (k/m, k g/m), k < m < 2^32, with the generator g whose shortest vector is longest among
/// many candidates: about as even as a hexagonal grid, for any m and without a seam.
struct RankOne {
  EvenLattice lattice;
  std::uint64_t g = 0;
};
RankOne even_lattice(std::uint64_t m);

/// Its points, k = 0 to m - 1.
std::vector<TorusPoint> points_of(const RankOne& lattice);

/// A reduced basis of the integer lattice spanned by (1, g) and (0, m), shorter vector first.
std::array<glm::i64vec2, 2> reduced_basis(std::uint64_t m, std::uint64_t g);

/// Indices of the points in the order of a Hilbert curve.
std::vector<std::uint32_t> hilbert_order(const std::vector<TorusPoint>& points);

}  // namespace capcon
