#pragma once

#include <cstdint>
#include <functional>

#include "points/point_set.h"

namespace capcon {

struct CcvtOptions {
  std::uint32_t sites = 1024;     ///< n >= 1
  std::uint32_t capacity = 1024;  ///< K >= 1 space points a site; n K <= 2^31
  std::uint64_t seed = 1;
  /// Called after each pass at the full capacity (coarser ones come first), may be empty. `energy` as in
  /// CcvtResult; it falls from pass to pass.
  std::function<void(double energy, std::uint64_t swaps)> on_pass = {};
  /// Called after each pass at any capacity with the fraction of the work that seems done, may be empty.
  std::function<void(double fraction)> on_progress = {};
  /// Whether to end now, asked after each pass and each round of the finish: the result then has exact
  /// capacities, at the capacity that was reached. May be empty.
  std::function<bool()> stop = {};
  /// Moves the sites on to the centroids of power cells of equal area: see transport_finish.h. The swaps
  /// before it then stop at a capacity of 64: it goes far beyond what they can do.
  bool finish = false;
};

struct CcvtResult {
  Points points;      ///< n sites, neighbours near each other in the order
  double energy = 0;  ///< n E / kHexagonEnergy of the *discrete* cells: E is the mean squared distance of a
                      ///< space point to its own site, a little above what `measure` says of the same sites;
                      ///< when finished, the energy of the power cells
  std::uint64_t passes = 0;    ///< over all capacities, coarse ones included
  std::uint64_t swaps = 0;     ///< exchanged pairs of space points, likewise
  std::uint32_t capacity = 0;  ///< of the cells: the one asked for, unless stopped before or finished
  bool stopped = false;        ///< by `stop`, before the end
  int rounds = 0;              ///< of the finish
};

/// Capacity-constrained points on the unit torus by swaps (Balzer, Schloemer, Deussen, "Capacity-constrained
/// point distributions", 2009): n K even space points, K for each site; sites exchange space points while
/// that lowers the summed squared distance, and stand at the centroids of theirs. Ends when a full pass over
/// all pairs of sites that could gain exchanges nothing. It starts from random cells with few space points
/// and refines them, which changes the time, not the end. Deterministic per (sites, capacity, seed).
/// InputError for n = 0, K = 0 or n K > 2^31.
CcvtResult ccvt(const CcvtOptions& options);

}  // namespace capcon
