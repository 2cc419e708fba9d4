#pragma once

#include <cstdint>
#include <vector>

#include "tiling/colouring.h"
#include "tiling/gaussian_tiling.h"
#include "tiling/tile_set.h"

namespace capcon {

/// The points of a stochastic toroidal tiling: colours[v] of every vertex; the first `ranks` points of every
/// tile, cell by cell. n = tiling.size() * ranks.
Points tile_points(const TileSet& set, const GaussianTiling& tiling,
                   const std::vector<std::uint32_t>& colours, std::uint32_t ranks);

/// The tile of a cell, from the colours of its four vertices.
std::uint32_t tile_of(const GaussianTiling& tiling, const std::vector<std::uint32_t>& colours,
                      std::uint32_t colour_count, std::uint32_t cell);

/// Vertex colours by hash of (seed, vertex), all colours allowed everywhere.
std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                          std::uint64_t seed);

/// Vertex colours that the set has tiles for.
std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, const TileSet& set,
                                          std::uint64_t seed);

}  // namespace capcon
