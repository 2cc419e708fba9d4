#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "points/ensemble.h"

namespace capcon {

/// Which set a pixel takes, and turned how, so that what neighbours err cancels: the image's error is blue
/// noise. The mask tiles the screen. Each key is there equally often, so that a mask shifted at random gives
/// a pixel every set and turn with the same probability: the estimate stays unbiased, and a pixel's error
/// what it is with random sets.
struct ScreenMask {
  static constexpr std::uint32_t kColumns = 64;
  std::uint32_t rows = 0;  ///< mask_rows(sets)
  /// keys[x + kColumns * y] = 8 * set + symmetry: for square and disk the bits are mirrored in x, mirrored in
  /// y, x and y exchanged, in this order; for the cylinder 2 bits quarter turns and, lowest, upside down.
  std::vector<std::uint16_t> keys;
};

/// Rows of a mask: the least number of at least 64 that has every key equally often.
std::uint32_t mask_rows(std::uint32_t sets);

/// A point of the unit square under symmetry 0 ... 7 of ScreenMask::keys.
glm::dvec2 apply_symmetry(EnsembleDomain domain, std::uint32_t symmetry, glm::dvec2 p);

/// The most points of a set, and sets: the matrix of all keys against each other is computed.
constexpr std::uint32_t kMostScreenPoints = 256, kMostScreenSets = 256;

/// Swaps keys while that lowers the mean square of the image's error behind a Gaussian of sigma 1 pixel
/// (simulated annealing). What two sets err is as correlated as their points are near each other: the mean of
/// spread_distance over pairs of one's cells and the other's, as within a set when the sets are made (for
/// half-planes Szekely and Rizzo 2013, energy distance). The same for any number of threads. InputError for
/// sets of more than kMostScreenPoints, or more than kMostScreenSets of them.
ScreenMask make_screen_mask(const Ensemble& ensemble, EnsembleDomain domain);

}  // namespace capcon
