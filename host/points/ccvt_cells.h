#pragma once

#include <cstdint>
#include <vector>

#include "points/lattice.h"

namespace capcon {

/// The difference b - a on the torus, each coordinate in [-2^31, 2^31).
inline std::int32_t difference(std::uint32_t b, std::uint32_t a) {
  return static_cast<std::int32_t>(b - a);
}

/// A site of a capacity-constrained diagram. Lengths are in units of 2^-32 of the torus.
struct CcvtSite {
  TorusPoint centre{0, 0};            ///< a fixed place near the site, the origin of what follows
  std::int64_t sum_x = 0, sum_y = 0;  ///< exact sum of the space points, relative to the centre
  double x = 0, y = 0;  ///< the site: the centroid of its space points, and the lead; relative to the centre
  float reach = 0;      ///< no space point is farther from the centre
  float inner = 0;      ///< the slots from `outer` on hold points no farther than this from the centre
  std::uint32_t outer = 0;
  double lead_x = 0, lead_y = 0;  ///< where the site is ahead of that centroid: see ccvt_leads.h
  double travel = 0;              ///< how far the site has moved in all, at least
};

/// The sites and their space points: exactly `capacity` slots a site, one site after another.
class CcvtCells {
 public:
  /// Site i gets the points (x[k], y[k]) with k / capacity = i.
  CcvtCells(std::uint32_t capacity, std::vector<std::uint32_t> x, std::vector<std::uint32_t> y);
  CcvtCells(std::uint32_t capacity, const std::vector<TorusPoint>& points);

  std::uint32_t capacity() const { return capacity_; }
  std::size_t size() const { return sites.size(); }
  std::uint32_t* x(std::size_t i) { return x_.data() + i * capacity_; }
  std::uint32_t* y(std::size_t i) { return y_.data() + i * capacity_; }
  const std::uint32_t* x(std::size_t i) const { return x_.data() + i * capacity_; }
  const std::uint32_t* y(std::size_t i) const { return y_.data() + i * capacity_; }

  /// Moves the centre to the site and sorts the slots into outer and inner ones.
  void refit(std::size_t i);
  /// The site from its sums and its lead.
  void place(std::size_t i) {
    CcvtSite& site = sites[i];
    site.x = static_cast<double>(site.sum_x) / capacity_ + site.lead_x;
    site.y = static_cast<double>(site.sum_y) / capacity_ + site.lead_y;
  }
  /// Whether a cell is so large that its points' nearest images may change when the site moves.
  bool is_large(std::size_t i) const { return sites[i].reach > 0x1p29f; }

  /// n / m times the sum of squared distances of all m space points to their sites, in units of the torus.
  double energy() const;

  std::vector<CcvtSite> sites;

 private:
  void sum_up(std::size_t i);

  std::uint32_t capacity_;
  float inner_radius_;
  std::vector<std::uint32_t> x_, y_;
};

}  // namespace capcon
