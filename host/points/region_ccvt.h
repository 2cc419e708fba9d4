#pragma once

#include "points/ccvt.h"
#include "points/region.h"

namespace capcon {

/// Capacity-constrained points of any region: n K space points of equal mass, spread over it by its density,
/// K for each site, exchanged as in `ccvt` until no pair gains; each site's cell holds 1/n of the mass. On
/// the square and the disk nothing wraps around: they are optimised in a quarter of the torus. `on_progress`
/// is called as there, `on_pass` with the energy in units of the torus. InputError as `ccvt`, and for a
/// density without mass. With `finish` in the square, power cells of exactly equal area, cut off at its sides
/// (transport_finish.h); InputError elsewhere.
Points region_ccvt(const Region& region, const CcvtOptions& options);

/// The cells behind the points, for those who want to check them: the space points of one site after another,
/// and the sites, all in [0, 1]^2.
struct RegionCells {
  Points sites;
  Points space_points;
};
RegionCells region_ccvt_cells(const Region& region, const CcvtOptions& options);

}  // namespace capcon
