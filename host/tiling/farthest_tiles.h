#pragma once

#include <cstdint>
#include <functional>

#include "tiling/tied_points.h"

namespace capcon {

/// How tiles with farthest-point-like tilings are made.
struct FarthestOptions {
  std::uint32_t rounds = 200;  ///< steps at each of 30 distances
  double flatness = 0.0002;    ///< of the mean tile against distance; 0 makes all tiles alike
  std::function<void(double done, double distance)> on_stage;  ///< done in [0, 1]; may be empty
};

/// Moves tied points away from each other until the least distance of two of them, in any tiling that there
/// is, is as large as can be found. Points are discs that push each other where they overlap: all pairs of
/// points that can meet count alike, however rare their neighbourhood. Their diameter grows from 0.7 to 0.93
/// of d_hex, the distance that farthest-point optimisation reaches without tiles; the pushes are followed
/// down to rest by FIRE (Bitzek et al. 2006, "Structural relaxation made simple"). `flatness` times the
/// unevenness of the mean tile, low frequencies first, is lowered with it. At least 4 points a tile.
TiedPoints spread_apart(TiedPoints points, const FarthestOptions& options);

/// The least distance of two points in any tiling, over d_hex = sqrt(2 / (sqrt(3) points_per_tile)).
double least_distance(const TiedPoints& points);

}  // namespace capcon
