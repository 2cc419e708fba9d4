#pragma once

#include <cstdint>
#include <functional>

#include "points/region.h"

namespace capcon {

struct LloydOptions {
  std::uint32_t n = 1024;  ///< n >= 1
  std::uint64_t seed = 1;
  std::uint32_t rounds = 300;
  Region region = {};
  /// Called after each round, may be empty.
  std::function<void(double fraction)> on_progress = {};
};

/// Lloyd's method: n independent random points, moved to the centroids of their Voronoi cells `rounds` times
/// (Lloyd, "Least squares quantization in PCM", 1982). Converges to centroidal Voronoi diagrams, slowly. The
/// cells are exact; with a density they are made of 256 space points a site instead, spread by it.
Points lloyd(const LloydOptions& options);

}  // namespace capcon
