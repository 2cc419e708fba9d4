#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "tiling/tied_points.h"
#include "tiling/tile_set.h"

namespace capcon {

/// The recipe of a tile set; the defaults make the shipped one.
struct MakeTilesOptions {
  std::uint32_t colours = 2;
  std::uint32_t points_per_tile = 16;
  std::uint32_t shared_corner = 0;  ///< points of a tile's quadrant that belong to the corner (RegionCounts)
  std::uint32_t shared_edge = 0;    ///< points of a tile's side that belong to the edge
  std::uint64_t seed = 1;
  std::uint32_t starts = 6;    ///< random starts, the best of which is finished
  std::uint32_t rounds = 200;  ///< rounds of the finish; a start gets half of them
  std::uint32_t tilings =
      24;  ///< random 8 x 8 tilings that the finish optimises on; a start has a third of them
  std::uint32_t moves = 20000;  ///< of the ranking, per point of the set
  double flatness = 0.001;      ///< see TiedOptimiser; 0 ends in a regular lattice
  std::function<void(double done, double energy)> on_round;  ///< done in [0, 1]; may be empty
};

/// Optimises and ranks a complete tile set. The same options give the same bits, for any number of threads.
/// InputError for options out of range.
TileSet make_tiles(const MakeTilesOptions& options);

/// "capcon tiles make" with the options that differ from the defaults.
std::string recipe(const MakeTilesOptions& options);

}  // namespace capcon
