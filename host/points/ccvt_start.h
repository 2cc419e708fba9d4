#pragma once

#include <cstdint>

#include "points/ccvt_cells.h"

namespace capcon {

/// Sites with their space points, and the lattice that these form.
struct CcvtState {
  CcvtCells cells;
  EvenLattice lattice;
};

/// A random start: even space points, cut again and again along random lines until each part holds one site's
/// share.
CcvtState random_cells(std::uint32_t sites, std::uint32_t capacity, std::uint64_t seed);

/// The same sites with another capacity, in about the same cells. For four times the capacity each space
/// point becomes four around it; otherwise new even space points go to the sites that own their surroundings.
CcvtState refined_cells(const CcvtState& coarse, std::uint32_t capacity, std::uint64_t seed);

}  // namespace capcon
