#pragma once

#include <cstdint>
#include <vector>

#include "points/partition.h"

namespace capcon {

/// partition() for the parts of trajectory splitting, whatever their number: labels in [0, k) of subsets
/// whose sizes differ by at most one. Small sets (kManyTries points at most) take the best of several seeds,
/// by the mean and the worst subset's mean distance to the nearest point. Where partition's tables would take
/// more than 64 MiB, every subset gets one of every k points that follow each other on a Morton curve.
std::vector<std::uint32_t> spread_partition(const Points& points, const PartitionOptions& options);

/// Mean over the subsets of the mean distance of a subset's points to their nearest, in units of the
/// hexagonal lattice's of as many points, and the least one. Subsets of one point count as 1.
struct SubsetSpacing {
  double mean = 1, worst = 1;
};
SubsetSpacing subset_spacing(const Points& points, const std::vector<std::uint32_t>& labels,
                             std::uint32_t subsets);

}  // namespace capcon
