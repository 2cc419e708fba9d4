#pragma once

#include <vector>

#include "tiling/equal_cells.h"

namespace capcon {

/// A toroidal tiling to optimise on, and how much each of its tiles counts.
struct TrainingTiling {
  GaussianTiling tiling;
  std::vector<std::uint32_t> colours;
  double weight = 1;
};

/// Moves tied points to lower the weighted mean energy of capacity-constrained cells over the training
/// tilings, plus `flatness` times the unevenness of the mean tile (mean_tile.h).
class TiedOptimiser {
 public:
  TiedOptimiser(TiedPoints points, std::vector<TrainingTiling> tilings, double flatness);

  /// One round: equal cells in every tiling, then every free point to the minimiser for these cells. Returns
  /// the objective before the move: n E / (5 / (18 sqrt 3)) of the training tilings + flatness * unevenness.
  double round(double tolerance = 1e-3, double stride = 1);

  const TiedPoints& points() const { return points_; }
  void set_points(TiedPoints points) { points_ = std::move(points); }
  double energy() const { return energy_; }

 private:
  TiedPoints points_;
  std::vector<TrainingTiling> tilings_;
  std::vector<EqualCells> cells_;
  double flatness_;
  double energy_ = 0;
};

}  // namespace capcon
