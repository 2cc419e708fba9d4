#pragma once

#include <cstdint>

#include "points/ensemble.h"

namespace capcon {

/// The cells of an ensemble's grid, dealt to sets of n that are fairly even already. For powers of two the
/// sets are the cosets of a (0,m,2)-net under Owen scrambling, nets themselves; else every set gets one of as
/// many cells as there are sets that follow each other on a Morton curve.
Ensemble start_ensemble(std::uint32_t n, std::uint32_t wished_sets, std::uint64_t seed);

/// How many sets that gives: a power of two near `wished_sets` for such n; else as many as a grid of nearly
/// square cells allows, which for an n with a large prime factor can be far more.
std::uint32_t sets_of_start(std::uint32_t n, std::uint32_t wished_sets);

}  // namespace capcon
