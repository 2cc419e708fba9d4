#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "points/ensemble.h"

namespace capcon {

/// The swaps of make_ensemble for large sets, at a fraction of the cost: in every round all sets meet in
/// pairs, drawn by hash, and a cell is exchanged only for one near it, as those far away never gain. What is
/// raised is the same sum of all distances within the sets. Each set's sums of distances to its own cells are
/// kept from round to round, so that a meeting computes only those between its two sets, and keeps none:
/// n^2 and 4 n a swap. `centres`: of the cells, in space. The same for any number of threads.
void swap_near(Ensemble& ensemble, EnsembleDomain domain, const std::vector<glm::vec3>& centres,
               std::uint32_t rounds, std::uint64_t seed);

}  // namespace capcon
