#pragma once

#include <cstdint>

#include "points/point_set.h"

namespace capcon {

enum class LatticeKind : std::uint8_t { kMaximin, kGolden };

/// The generator g in [0, n/2] for which the shortest vector of the lattice (k/n, k g/n) on the torus is
/// longest, the least one of several: the best by distance among all n candidates (Dammertz and Keller,
/// "Image synthesis by rank-1 lattices", 2008). Every g is looked at, most of them briefly: the shortest
/// vector is one of the convergents (q, r) of Euclid's algorithm on g and n, and the first that is shorter
/// than the best so far ends the look. O(n) such looks: 0.01 s for n = 10^5, a few seconds for 10^8. n >= 1.
std::uint32_t maximin_generator(std::uint32_t n);

/// n points of a lattice, point k being
/// kMaximin  (k/n, k g/n mod 1) with the generator above: no seam on the torus
/// kGolden   (k/n, k/phi mod 1), phi the golden ratio: even for any n and any range of k, with a seam at x =
/// 0
Points lattice_points(LatticeKind kind, std::uint32_t n);

/// Every point moved by the same random vector of the torus (Cranley and Patterson 1976).
void shift_randomly(Points& points, std::uint64_t seed);

}  // namespace capcon
