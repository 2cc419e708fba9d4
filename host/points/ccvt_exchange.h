#pragma once

#include <cstdint>
#include <vector>

#include "points/ccvt_cells.h"

namespace capcon {

/// Buffers of one thread.
struct CcvtScratch {
  struct Candidate {
    float key;
    std::uint32_t slot;
  };
  std::vector<float> keys_i, keys_j;
  std::vector<Candidate> from_i, from_j;
};

/// Exchanges space points between sites i and j as long as that gains, best first, then moves both sites to
/// the centroids of their points. The gain of moving a space point from i to j grows with its place along s_j
/// - s_i, so the best exchange sorts both sets by that and trades the foremost of each while they are on the
/// wrong sides. Touches nothing but the two sites. Returns the number of points exchanged.
std::uint32_t exchange(CcvtCells& cells, std::size_t i, std::size_t j, CcvtScratch& scratch);

}  // namespace capcon
