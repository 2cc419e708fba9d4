#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tiling/tied_points.h"
#include "tiling/tile_set.h"

namespace capcon {

/// What the points of tilings are to be.
enum class TileMethod : std::uint8_t {
  ccvt,  ///< capacity-constrained: sites of compact cells of equal area (tied_optimiser.h)
  fpo,   ///< farthest-point-like: the least distance as large as can be (farthest_tiles.h)
};

/// The recipe of a tile set; the defaults make the shipped one.
struct MakeTilesOptions {
  std::uint32_t colours = 2;  ///< in a bounded set those inside; outside is one more
  std::uint32_t points_per_tile = 16;
  Colouring colouring = Colouring::free;
  TileMethod method = TileMethod::ccvt;
  std::uint32_t shared_corner = 0;  ///< points of a tile's quadrant that belong to the corner (RegionCounts)
  std::uint32_t shared_edge = 0;    ///< points of a tile's side that belong to the edge
  std::uint64_t seed = 1;
  std::uint32_t starts = 6;     ///< random starts, the best of which is finished
  std::uint32_t rounds = 200;   ///< rounds of the finish; a start gets half of them
  std::uint32_t tilings = 0;    ///< random 8 x 8 tilings that the finish optimises on, a start on a third of
                                ///< them; 0: 24, more for sets of more than 16 tiles (24 for bounded ones,
                                ///< which have more of the small tilings)
  std::uint32_t moves = 20000;  ///< of the ranking, per point of the set
  std::optional<double> flatness;  ///< of the mean tile, see TiedOptimiser and FarthestOptions; 0 ends in a
                                   ///< regular lattice. Left out: 0.002 for ccvt, 0.0002 for fpo, 0.0012 for
                                   ///< bounded sets
  std::function<void(double done, double energy)> on_round;  ///< done in [0, 1]; may be empty
};

/// Optimises and ranks a tile set. The same options give the same bits, for any number of threads.
/// InputError for options out of range.
TileSet make_tiles(const MakeTilesOptions& options);

/// "capcon tiles make" with the options that differ from the defaults.
std::string recipe(const MakeTilesOptions& options);

}  // namespace capcon
