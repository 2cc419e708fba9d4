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

/// Passes over all pairs of sites that may gain, until one exchanges fewer than `enough` space points: 1 goes
/// on until nothing can be gained. `on_pass` gets the number of each pass's exchanges; when `stop` says so
/// after a pass, that was the last. The pairs of a pass are shared out over all threads, with the same result
/// for any number of them.
CcvtEffort optimise(CcvtCells& cells, std::uint64_t enough = 1,
                    const std::function<void(std::uint64_t swaps)>& on_pass = {},
                    const std::function<bool()>& stop = {});

}  // namespace capcon
