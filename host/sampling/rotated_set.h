#pragma once

#include <memory>
#include <string>

#include "points/point_set.h"
#include "sampling/sampler.h"

namespace capcon {

/// One set of points for all, turned on the torus by a random shift a (pixel, dimension pair), which is
/// unbiased for any set: points p * n ... (p + 1) * n - 1 are part p, n = points.size() / parts.
std::unique_ptr<Sampler> make_rotated_set_sampler(std::string name, const Points& points, std::uint32_t seed,
                                                  std::uint32_t parts);

/// The parts of a distance-based partition (spread_partition.h) one after another, each in Morton order.
Points part_by_part(const Points& points, std::uint32_t parts);

}  // namespace capcon
