#pragma once

#include <cstdint>
#include <functional>

#include "points/point_set.h"

namespace capcon {

struct FinishOptions {
  /// The descent ends when a round lowers the energy by less than this part of it, on the mean of the last 20
  /// rounds: at an energy near 1.008, whatever n. More rounds bring little but larger grains of hexagons ...
  double tolerance = 2e-5;
  /// ... or after so many rounds ...
  int most_rounds = 1000;
  /// ... or when this says so, asked before each round with the number of rounds and the energy E_ot; may be
  /// empty.
  std::function<bool(int round, double energy)> stop;
  /// In the unit square, whose sides do not meet, instead of the torus: power cells end at the sides. Costs
  /// four times as much.
  bool square = false;
};

struct FinishResult {
  Points points;
  double energy = 0;      ///< E_ot of the points, power cells balanced (in the square: with cells cut off)
  double area_error = 0;  ///< largest |n area - 1| of the power cells
  int rounds = 0;
  bool stopped = false;  ///< by `stop`
};

/// Moves points until each stands at the centroid of its power cell, all of which have the same area 1/n: a
/// local minimum of the transport energy (de Goes, Breeden, Ostromoukhov, Desbrun, "Blue noise through
/// optimal transport", 2012, state the functional). The energy is lowered over the sites by limited-memory
/// BFGS (Nocedal 1980): its gradient is 2/n (site - centroid). A round costs one diagram: the weights follow
/// by one Newton step, with the change of the areas that the sites' move brings about to first order; steps
/// that raise the energy or come near to emptying a cell are halved. At the end the weights are balanced
/// until all areas are 1/n but for 1e-10 of it. Any points in [0, 1)^2, also n = 1; points that coincide are
/// parted first. Deterministic for any number of threads.
FinishResult transport_finish(const Points& points, const FinishOptions& options = {});

}  // namespace capcon
