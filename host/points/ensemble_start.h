#pragma once

#include <cstdint>

#include "points/ensemble.h"

namespace capcon {

/// The cells of an ensemble's grid, dealt to sets of n that are fairly even already. For powers of two the
/// sets are the cosets of a (0,m,2)-net under Owen scrambling, nets themselves; else every set gets one of as
/// many cells as there are sets that follow each other on a Morton curve.
Ensemble start_ensemble(std::uint32_t n, std::uint32_t wished_sets, std::uint64_t seed);

}  // namespace capcon
