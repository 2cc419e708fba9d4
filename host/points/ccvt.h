#pragma once

#include <cstdint>
#include <functional>

#include "points/point_set.h"

namespace capcon {

struct CcvtOptions {
  std::uint32_t sites = 1024;     ///< n >= 1
  std::uint32_t capacity = 1024;  ///< K >= 1 space points a site
  std::uint64_t seed = 1;
  std::function<void(double energy, std::uint64_t swaps)> on_pass;  ///< called after each pass, may be empty
};

struct CcvtResult {
  Points points;      ///< n sites
  double energy = 0;  ///< n E / 0.160375... of the *discrete* cells (mean squared distance of space points)
  std::uint64_t passes = 0;
  std::uint64_t swaps = 0;
};

/// Capacity-constrained points on the unit torus by swaps (Balzer et al. 2009, see docs): ends when a full
/// pass over all pairs of sites that could gain swaps nothing. Deterministic per (sites, capacity, seed).
CcvtResult ccvt(const CcvtOptions& options);

}  // namespace capcon
