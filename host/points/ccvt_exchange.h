#pragma once

#include <cstdint>
#include <vector>

#include "points/ccvt_cells.h"
#include "points/ccvt_keys.h"

namespace capcon {

/// What a look at a pair of sites finds: a direction u (a unit vector about from i to j), and that no point p
/// of i has u . (p - centre of i) > most_i and no q of j has -u . (q - centre of j) > most_j. Nothing can be
/// gained while most_i + most_j <= limit and u stays.
struct CcvtFront {
  float ux, uy, most_i, most_j, limit;
};

/// Buffers of one thread, and what the last exchange found.
struct CcvtScratch {
  std::vector<float> keys_i, keys_j;
  std::vector<CcvtCandidate> from_i, from_j;  ///< points changed places in the first slots of both
  std::uint32_t count_i = 0, count_j = 0;     ///< candidates in them
  CcvtFront front;                            ///< after it
  bool refitted_i = false, refitted_j = false;
};

/// Exchanges space points between sites i and j as long as that gains, best first, then moves both sites to
/// the centroids of their points. The gain of moving a space point from i to j grows with its place along s_j
/// - s_i, so the best exchange sorts both sets by that and trades the foremost of each while they are on the
/// wrong sides. Touches nothing but the two sites. Returns the number of points exchanged.
std::uint32_t exchange(CcvtCells& cells, std::size_t i, std::size_t j, CcvtScratch& scratch);

}  // namespace capcon
