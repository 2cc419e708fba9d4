#pragma once

#include <cstddef>
#include <cstdint>

#include "points/ccvt_cells.h"

namespace capcon {

/// Of the space points in slots [0, count), whatever their order: two sets that differ have different ones,
/// but for a chance of 2^-64.
std::uint64_t content_of(const std::uint32_t* x, const std::uint32_t* y, std::size_t count);

/// What an exchange between two sites may do, in whole numbers, so that there is no rounding to allow for:
/// made before it, asked after it.
class ExchangeCheck {
 public:
  ExchangeCheck(const CcvtCells& cells, std::size_t i, std::size_t j);

  /// After `count` points of each changed over. Throws BrokenInvariant unless both sites together have the
  /// points that they had, sums and radii are right, the energy fell for the sites as they stood (which is
  /// why points are exchanged) and, where both stand at their centroids, without leads, it fell with the
  /// sites moved to the new ones (which is why exchanges end: no assignment of points to sites can come
  /// again).
  void end(std::uint32_t count) const;

 private:
  __extension__ using Wide = __int128;
  struct Before {
    CcvtSite site;
    bool large;
    std::int64_t sum_x, sum_y;
    Wide at_site;  ///< sum of squared distances to the site, rounded to whole units, by nearest images
    Wide own;      ///< K times the sum of squared distances to the centroid
  };
  Before look(std::size_t s) const;
  Wide distances(std::size_t s, const CcvtSite& site) const;
  Wide own_energy(std::size_t s) const;
  void check_site(std::size_t s) const;

  const CcvtCells& cells_;
  std::size_t i_, j_;
  std::uint64_t content_;
  Before before_i_, before_j_;
};

}  // namespace capcon
