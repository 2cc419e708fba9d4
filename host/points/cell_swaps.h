#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "points/ensemble.h"

namespace capcon {

/// Of terms of spread_distance.
struct SpreadWeights {
  float directions = 1;  ///< of the terms along axes and on the hemisphere
  float smooth = 10;     ///< of the power 3/2
};

/// Those for sets of n points. Directions count less in small sets, where they cost smooth integrands more
/// than they bring; two or three points that are as far apart as can be see no disk in the middle of the
/// square.
inline SpreadWeights spread_weights(std::size_t n) {
  return {std::clamp(static_cast<float>(n) / 64.0f, 0.3f, 1.0f), n < 4 ? 0.0f : 10.0f};
}

/// What swaps raise the sum of within a set, over pairs of its points: the distance, which makes the mean
/// squared discrepancy over half-planes small (of caps of the sphere for the cylinder), and
/// - a short-ranged part that decides where half-planes leave a choice, as between all pairs of two points on
///   opposite sides of the middle;
/// - in the square and the disk the distance along either axis: half-planes along them, which scenes with
///   straight walls have more of than others;
/// - in the square the distance to the power 3/2: low frequencies, that is smooth integrands. Their error is
///   0.3 to 0.7 of what it was without, that of edges the same; weights of 3 to 30 are much alike;
/// - in the disk a power of the distance on the hemisphere above it: caps, as what occludes near the horizon.
/// (dx, dy, dz): between the points, dz on the hemisphere above the disk, on the sphere for the cylinder.
template <EnsembleDomain domain>
inline float spread_distance(float dx, float dy, float dz, const SpreadWeights& weights) {
  constexpr float kShort = 0.05f, kRange = 0.3f, kAlong = 0.2f, kAbove = 1.0f;
  const float flat = dx * dx + dy * dy, all = flat + dz * dz;
  const float d = std::sqrt(domain == EnsembleDomain::cylinder ? all : flat);
  float spread = d + kShort * d / (kRange + d);
  if constexpr (domain != EnsembleDomain::cylinder)
    spread += weights.directions * kAlong * (std::abs(dx) + std::abs(dy));
  if constexpr (domain == EnsembleDomain::square) spread += weights.smooth * d * std::sqrt(d);
  if constexpr (domain == EnsembleDomain::disk)
    spread += weights.directions * kAbove * std::sqrt(std::sqrt(all));
  return spread;
}

/// Where spread_distance has a point of the unit square: in space (in_space), on the hemisphere above the
/// disk.
glm::vec3 spread_place(EnsembleDomain domain, glm::dvec2 p);

/// Two sets a and b of n cells each swap cells while that raises the sum, within the sets, of
/// spread_distance of two cells' centres; at most three passes. Returns whether anything was swapped. O(n^2)
/// a pass.
bool swap_cells(EnsembleDomain domain, const std::vector<glm::vec3>& centres, std::uint32_t* a,
                std::uint32_t* b, std::uint32_t n);

}  // namespace capcon
