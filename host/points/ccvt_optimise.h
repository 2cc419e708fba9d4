#pragma once

#include <cstdint>
#include <functional>

#include "points/ccvt_cells.h"

namespace capcon {

struct CcvtEffort {
  std::uint64_t passes = 0;
  std::uint64_t swaps = 0;
  bool stopped = false;  ///< before the end, by `stop`
};

/// When to end, and how boldly to go.
struct CcvtPace {
  std::uint64_t enough = 1;           ///< ends with a pass of fewer exchanges: 1: nothing can be gained
  std::uint64_t most_passes = ~0ull;  ///< ... or after so many
  double lead = 0;                    ///< see ccvt_leads.h; 0: each exchange lowers the energy
};

/// For a coarse capacity, which is but a start for the next: few exchanges a site are near enough to its end.
CcvtPace coarse_pace(std::size_t sites, std::uint32_t capacity);

/// Passes over all pairs of sites that may gain. `on_pass` gets the number of each pass's exchanges; when
/// `stop` says so after a pass, that was the last. The pairs of a pass are shared out over all threads, with
/// the same result for any number of them.
CcvtEffort optimise(CcvtCells& cells, const CcvtPace& pace = {},
                    const std::function<void(std::uint64_t swaps)>& on_pass = {},
                    const std::function<bool()>& stop = {});

}  // namespace capcon
