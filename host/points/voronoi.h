#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "points/kd_tree.h"
#include "points/measure.h"
#include "points/point_set.h"

namespace capcon {

/// The periodic Voronoi diagram of points on the unit torus, one cell at a time. A cell starts as the unit
/// square about its site (the bisectors with the site's own images) and is cut by the bisectors of other
/// sites, ring by ring of a grid, until no site can be near enough to cut (twice the farthest corner: the
/// security radius). Where the grid is crowded the rest comes from a tree whose boxes are skipped when no
/// corner of the cell is nearer to them than to its site. Const and thread-safe after construction.
class PeriodicVoronoi {
 public:
  explicit PeriodicVoronoi(const Points& points);

  /// What one thread needs to cut cells; reuse it to save allocations.
  struct Scratch {
    std::vector<glm::dvec2> corners, next;
    std::vector<KdTree::Entry> queue;
  };

  /// Cuts the cell of point i into scratch.corners (counter-clockwise, relative to the point; empty for a
  /// point that coincides with an earlier one). Returns the squared toroidal distance to the nearest other
  /// point; 1 when n = 1, the distance to the point's own images.
  double cut(std::size_t i, Scratch& scratch) const;

  /// All points, neighbours near each other: cutting in this order is faster.
  const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  /// Whether other points lie at the same place, and whether this is the first of them, which keeps the cell.
  enum class Twin : std::uint8_t { kNone, kFirst, kLater };

  double cut_rest_by_tree(std::uint32_t i, Scratch& scratch, double nearest) const;

  std::vector<glm::dvec2> sites_;  ///< multiples of 2^-53, so that differences are exact
  std::vector<Twin> twin_;
  int side_ = 1;                       ///< grid cells a side
  std::vector<std::uint32_t> start_;   ///< first entry of a grid cell in order_
  std::vector<std::uint32_t> order_;   ///< distinct sites by grid cell, then the later twins
  std::vector<glm::dvec2> positions_;  ///< sites_ in that order
  KdTree tree_;                        ///< empty unless a grid cell is crowded
};

/// Area, centroid and second moment about the origin of a convex polygon that holds the origin, by the
/// triangles that its edges span with it: area a = cross/2, a (p+q)/3, a (p.p + p.q + q.q)/6.
void integrate_polygon(const std::vector<glm::dvec2>& corners, double& area, glm::dvec2& centroid,
                       double& second_moment);

}  // namespace capcon
