#pragma once

#include <bit>
#include <cstdint>

#include "points/ensemble.h"

namespace capcon {

/// Orders the cells of every set so that beginnings are as even as can be too, for sets of which only the
/// first points are taken yet. A set of n = q m, with q = 2^k regions of halving it along its sides in turn,
/// q^2 <= n, becomes m classes of q cells, one of each region: cell c q + t is the one of class c in region
/// ranked_region(t, k). What swaps between classes (of cells in one region) raise is the sum of
/// spread_distance (cell_swaps.h) within aligned blocks of 2, 4, 8, ... cells, each weighted so that blocks
/// of all sizes err in proportion to what such sets err at best. n is a power of two, k at most 5.
void rank_cells(Ensemble& ensemble, EnsembleDomain domain);

/// The region of the t-th cell of a class: bits x0 y0 x1 y1 ... of the Sobol' (0,2)-sequence's point t, so
/// that the first 2, 4, 8, ... are nets of regions.
constexpr std::uint32_t ranked_region(std::uint32_t t, std::uint32_t k) {
  const auto odd = [](std::uint32_t bits) { return static_cast<std::uint32_t>(std::popcount(bits)) & 1; };
  const std::uint32_t four = (t & 1) << 3 | odd(t) << 2 | (t & 2) | odd(t & 10);
  return k == 5 ? four << 1 | (t >> 2 & 1) : four >> (4 - k);
}

}  // namespace capcon
