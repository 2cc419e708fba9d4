#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace capcon {

/// The domain of an integral, reached from the unit square by areas in proportion: itself, the unit disk by
/// the concentric map (Shirley and Chiu 1997), or itself with its sides x = 0 and x = 1 joined: azimuth and
/// height.
enum class EnsembleDomain { square, disk, cylinder };

/// Many sets of n cells each. All cells are alike in area and together tile the domain, so that a random set
/// with a random point in each of its cells is unbiased for any integrand: every cell is as likely as any
/// other, and every point of it. Each set covers the domain as evenly as can be.
struct Ensemble {
  std::uint32_t columns = 1, rows = 1;  ///< of the grid of cells in the unit square
  std::uint32_t sets = 1;
  /// cells[s * n + i]: cell i of set s, column + columns * row.
  std::vector<std::uint32_t> cells;
};

/// More take many seconds and megabytes.
constexpr std::uint32_t kMostEnsemblePoints = 4096;

/// Whether make_ensemble makes sets of so many points: 1 to 1024; and up to kMostEnsemblePoints those numbers
/// that a grid fits, which all multiples of 64 are. (With a large prime factor there would be many times the
/// cells.)
bool can_make_ensemble(std::uint32_t points);

struct EnsembleOptions {
  std::uint32_t points = 16;  ///< n >= 1, of a set
  EnsembleDomain domain = EnsembleDomain::disk;
  std::uint64_t seed = 1;
  /// How many sets are wished, 0: 256 for small sets to 64 for large ones, and beyond 1024 points as many as
  /// make 65,536 cells. Finer cells err less, and tables are larger.
  std::uint32_t sets = 0;
  /// How long it may take: distances computed, about 1e9 a second of processor time.
  double effort = 5e8;
};

/// Deals the cells of a grid to sets (ensemble_start.h), and swaps cells between two sets while that lowers
/// the sum of their energy distances to the domain, ED(X) = (2/n) sum u(x_i) - (1/n^2) sum |x_i - x_j| -
/// const (Szekely and Rizzo 2013): the mean squared discrepancy over half-planes (over caps of the
/// sphere, for the cylinder); other terms weigh some of them more (spread_distance in cell_swaps.h). The sum
/// over u does not change, so that what counts is the distances within the sets. Meetings of sets that have
/// no set in common are worked on at the same time; the result is the same for any number of threads. Beyond
/// 1024 points only cells near each other are swapped (near_swaps.h). InputError where can_make_ensemble says
/// no.
Ensemble make_ensemble(const EnsembleOptions& options);

/// Orders the cells of every set so that cells p * n / parts ... (p + 1) * n / parts - 1, part p, cover the
/// domain as evenly as can be too: the same swaps between the parts of a set. `parts` divides n.
void deal_parts(Ensemble& ensemble, EnsembleDomain domain, std::uint32_t parts);

/// Mean over the sets of (1/n^2) sum |x_i - x_j|, at the cells' centres: what the swaps raise.
double mean_distance_within(const Ensemble& ensemble, EnsembleDomain domain);

/// A point of the unit square in the domain.
glm::dvec2 into_domain(EnsembleDomain domain, glm::dvec2 p);

/// The same in space: square and disk in z = 0, and of the cylinder the unit sphere, which it has the areas
/// of (Archimedes).
glm::dvec3 in_space(EnsembleDomain domain, glm::dvec2 p);

}  // namespace capcon
