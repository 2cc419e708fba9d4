#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tiling/power_cell.h"
#include "tiling/tied_points.h"
#include "tiling/tiling.h"

namespace capcon {

/// The capacity-constrained cells of all sites of one tiling, toroidal or bounded as the points' set is (a
/// bounded one's cells end at the square's sides), in units of a tile's side: power cells
/// of exactly the same area 1/nt, which are the cells of least summed energy for these sites and capacities
/// (Aurenhammer, Hoffmann and Aronov 1998). The weights follow from damped Newton steps on the areas
/// (Kitagawa, Merigot and Thibert 2019). It is the limit of swapping space points between sites as the
/// capacity goes to infinity.
class EqualCells {
 public:
  EqualCells(const GaussianTiling& tiling, const std::vector<std::uint32_t>& colours,
             const TiedPoints& points);

  /// Solves for the points' present positions, from the last solution on, until every area is within
  /// `tolerance` of 1/nt, relatively. Far from the optimum, where Newton's steps may fail, it leaves the
  /// Voronoi cells instead.
  void solve(const TiedPoints& points, double tolerance);

  const std::vector<PowerCell>& cells() const { return cells_; }
  /// The free point that stands at a site; sites are tile by tile.
  std::uint32_t free_point(std::size_t site) const { return free_point_[site]; }
  std::size_t site_count() const { return free_point_.size(); }
  /// Mean of |x - site|^2 over the torus, or the square.
  double energy() const;

 private:
  static constexpr std::uint32_t kNoTile = ~0u;

  void find_neighbours(const TiedPoints& points);
  void place_neighbours(const TiedPoints& points);
  void compute_cells();
  void use_voronoi_cells();
  bool newton_step();
  double residual2() const;
  double worst_error() const;
  double least_area() const;
  std::vector<double> newton_direction() const;

  double target_;
  std::size_t per_tile_;
  std::vector<std::uint32_t> free_point_;
  std::vector<std::array<std::uint32_t, 9>> around_;  ///< per tile the tiles at (-1..1, -1..1), kNoTile
                                                      ///< beyond the sides of a bounded tiling
  std::vector<SiteBox> boxes_;  ///< per tile of a bounded tiling: where the square is, seen from the tile
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<TiedPoints::FreePoint> searched_at_;  ///< the free points when neighbours were sought last
  std::vector<double> weights_;
  std::vector<SiteBox> clip_;  ///< per site: what its cell is cut out of
  std::vector<PowerCell> cells_;
};

}  // namespace capcon
