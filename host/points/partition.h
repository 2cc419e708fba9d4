#pragma once

#include <cstdint>
#include <vector>

#include "points/point_set.h"

namespace capcon {

struct PartitionOptions {
  std::uint32_t subsets = 2;  ///< k: 1 <= k <= n
  std::uint64_t seed = 1;
};

/// The text's distance-based partition (appendix A.2): labels in [0, k) that cut a set on the unit torus into
/// k subsets whose sizes differ by at most one, each well spread, their union unchanged. From random labels,
/// points of two subsets trade places while that raises the sum of the two points' distances to the nearest
/// point of their subset; every point takes its best partner, pass after pass, until a pass trades nothing.
/// The sum over both points rises with every trade, yet others of the subsets may lose: the passes end at the
/// latest after kMostPasses. O(n^2) a pass. Deterministic. InputError for k = 0 or k > n.
std::vector<std::uint32_t> partition(const Points& points, const PartitionOptions& options);

/// The subsets themselves, each in the order of the points.
std::vector<Points> split(const Points& points, const std::vector<std::uint32_t>& labels,
                          std::uint32_t subsets);

}  // namespace capcon
