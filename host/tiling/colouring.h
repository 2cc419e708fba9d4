#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tiling/gaussian_tiling.h"

namespace capcon {

/// Which colours the ends of a lattice edge may have. A set holds the tiles whose four sides are allowed.
enum class Colouring : std::uint8_t {
  free,   ///< all: a complete set of C^4 tiles
  apart,  ///< colour 0 beside all, the others never beside themselves: a compact set of 7, 35, 121, ... tiles
};

/// "free", "apart": the words of the file format.
std::string_view colouring_name(Colouring colouring);

/// Whether the ends of an edge may be coloured a and b.
bool may_meet(Colouring colouring, std::uint32_t a, std::uint32_t b);

/// The numbers of the tiles whose sides are all allowed, in order.
std::vector<std::uint32_t> tile_numbers(std::uint32_t colours, Colouring colouring);

/// Vertex colours of a tiling by hash of (seed, vertex); no order, no search, and valid on every torus.
///
/// free: each vertex draws one of all colours.
/// apart: each vertex draws a first wish of the colours 1 to C - 1, a second one of the rest of these, and a
/// priority. It gets its first wish unless a neighbour of higher priority has the same one; else its second
/// wish, unless a neighbour got it so or another one that missed its first wish and has higher priority
/// wishes it too; else 0. So a colour follows from the draws of the vertices at most two edges away.
std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                          Colouring colouring, std::uint64_t seed);

/// How often each tile number occurs in an infinite random tiling, 0 for tiles that do not exist. free: all
/// C^-4; apart: counted in one torus of 512 x 512 tiles.
std::vector<double> tile_shares(std::uint32_t colours, Colouring colouring);

}  // namespace capcon
