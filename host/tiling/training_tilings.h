#pragma once

#include "tiling/tied_optimiser.h"

namespace capcon {

/// The tile set to train, all of its colours counted.
struct TrainingSet {
  std::uint32_t colours = 2;
  Colouring colouring = Colouring::free;
  std::uint64_t seed = 1;
};

/// `count` random tilings of 8 x 8 tiles, and with some of the weight those of few tiles, which renderers use
/// most: tori of 1, 2, 4 and 8 tiles; bounded squares of 2 x 2, 3 x 3 and 4 x 4.
std::vector<TrainingTiling> training_tilings(const TrainingSet& set, std::uint32_t count);

}  // namespace capcon
