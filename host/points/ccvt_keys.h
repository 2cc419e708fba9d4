#pragma once

#include <cstdint>

#include "points/lattice.h"

namespace capcon {

/// A space point that may change over: its slot, and its place along the direction to the other site.
struct CcvtCandidate {
  float key;
  std::uint32_t slot;
};

/// The loops over the space points of a site that take most of the time, in versions for wider vectors.
/// All versions give the same bits: each key is rounded alike wherever it is computed, and a maximum does not
/// depend on the order.
struct CcvtKernels {
  /// keys[k] = u . (point k - centre) for the slots [begin, end); returns the largest, or `largest`.
  float (*project)(const std::uint32_t* x, const std::uint32_t* y, std::uint32_t begin, std::uint32_t end,
                   TorusPoint centre, float ux, float uy, float* keys, float largest);
  /// Sums of (point k - centre) for k < count into sum_x, sum_y; returns the largest coordinate of any,
  /// without its sign.
  double (*sum)(const std::uint32_t* x, const std::uint32_t* y, std::uint32_t count, TorusPoint centre,
                std::int64_t& sum_x, std::int64_t& sum_y);
  /// The slots in [0, count) whose key is above the limit, in order; returns how many. Room for `count`.
  std::uint32_t (*select)(const float* keys, std::uint32_t count, float limit, CcvtCandidate* into);
};

/// Four lanes: what every x86-64 and ARMv8 has.
CcvtKernels plain_ccvt_kernels();
/// The widest that this processor has.
CcvtKernels best_ccvt_kernels();

}  // namespace capcon
