#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tiling/gaussian_tiling.h"

namespace capcon {

/// Which colours the ends of a lattice edge may have. A set holds the tiles whose four sides are allowed.
enum class Colouring : std::uint8_t {
  free,   ///< all: a complete set of C^4 tiles
  apart,  ///< colour 0 beside all, the others never beside themselves: a compact set of 7, 35, 121, ... tiles
  bounded,  ///< the last colour is outside: tilings of a square whose sides do not meet, all vertices on its
            ///< sides outside. With C colours inside, C^4 inner, 4 C^2 side and 4 C corner tiles: 40 for C =
            ///< 2
};

/// Along the side of a bounded tiling, at least: with one tile there would be no vertex inside.
constexpr std::uint32_t kLeastBoundedSide = 2;

/// "free", "apart", "bounded": the words of the file format.
std::string_view colouring_name(Colouring colouring);

/// Which sides of a tile of a bounded set lie on the square's: at most two, which meet.
struct OutsideSides {
  bool left = false, right = false, bottom = false, top = false;
  int count() const { return left + right + bottom + top; }
};
/// By the colours of the corners (0,0), (1,0), (0,1), (1,1), of which `outside` is the one for outside.
OutsideSides outside_sides(const std::array<std::uint32_t, 4>& corners, std::uint32_t outside);

/// Whether the ends of an edge may be coloured a and b: not for bounded tilings, which are told by tiles.
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
/// bounded: of an a x a tiling (b = 0, a >= 2), the vertices of row and column 0, which are also those of row
/// and column a, are outside; the others draw one of the other colours. InputError for other tilings.
std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                          Colouring colouring, std::uint64_t seed);

/// How often each tile number occurs in an infinite random tiling, 0 for tiles that do not exist. free: all
/// C^-4; apart: counted in one torus of 512 x 512 tiles; bounded: in a square of 8 x 8 tiles.
std::vector<double> tile_shares(std::uint32_t colours, Colouring colouring);

}  // namespace capcon
