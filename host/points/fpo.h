#pragma once

#include <cstdint>
#include <functional>

#include "points/point_set.h"

namespace capcon {

struct FpoOptions {
  enum class Strategy : std::uint8_t { kGlobal, kLocal };

  std::uint32_t n = 1024;  ///< n >= 1
  std::uint64_t seed = 1;
  Strategy strategy = Strategy::kGlobal;
  /// Called now and then with the fraction of the work that seems done, may be empty.
  std::function<void(double fraction)> on_progress = {};
};

/// Farthest-point optimisation on the unit torus (Schloemer, Heck, Deussen, "Farthest-point optimized point
/// sets with maximized minimum distance", HPG 2011). Starts from random points; takes out one after another,
/// in a fixed random order, and puts each at the centre of the largest empty circle that the others leave, if
/// that is farther from them than it was. `kGlobal` looks for that circle everywhere, O(log n) a point;
/// `kLocal` only about the place where the point was, O(1) a point, in more passes. Ends when ten passes
/// raised the mean distance by less than 4e-5 of itself, or one moved no point. Deterministic per (n, seed,
/// strategy). InputError for n = 0.
Points fpo(const FpoOptions& options);

/// The same from given points in [0, 1)^2, which are parted first where they coincide (parted.h); `seed`
/// gives the order.
Points fpo_from(const Points& start, const FpoOptions& options);

}  // namespace capcon
