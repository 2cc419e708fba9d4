#pragma once

#include <cstdint>
#include <memory>

#include "points/density.h"
#include "points/point_set.h"

namespace capcon {

/// Where points live, always in [0, 1]^2: the unit torus, the unit square with sides that do not meet, or the
/// disk of radius 1/2 about (1/2, 1/2).
enum class Domain : std::uint8_t { kTorus, kSquare, kDisk };

/// A domain with a density on it; none means the same everywhere.
struct Region {
  Domain domain = Domain::kTorus;
  std::shared_ptr<const Density> density = {};

  bool is_plain_torus() const { return domain == Domain::kTorus && !density; }
};

/// Shirley and Chiu's concentric map ("A low distortion map between disk and square", 1997) from the unit
/// square to the disk of radius 1/2 about (1/2, 1/2): equal areas stay equal.
glm::dvec2 to_disk(glm::dvec2 u);
bool is_in_disk(glm::dvec2 p);

/// Maps the unit square to the region so that equal areas become equal masses. InputError for a density on
/// the disk, for which there is no such map.
glm::dvec2 place(const Region& region, glm::dvec2 u);

/// m points of equal mass, as evenly spread as may be: a lattice, mirrored and shifted at random, sent
/// through `place`; for a density on the disk scrambled Sobol' points of the square, of which those in the
/// disk count.
Points spread(const Region& region, std::uint64_t m, std::uint64_t seed);

/// Sends each of the points of the unit square through `place`.
void place_all(const Region& region, Points& points);

/// n independent random points.
Points random_points(const Region& region, std::uint32_t n, std::uint64_t seed);

}  // namespace capcon
