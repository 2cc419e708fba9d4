#include "integrate/cell_sums.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "points/voronoi.h"

namespace capcon::integrate {
namespace {

double farthest(const std::vector<glm::dvec2>& corners) {
  double distance2 = 0;
  for (const glm::dvec2& c : corners) distance2 = std::max(distance2, glm::dot(c, c));
  return std::sqrt(distance2);
}

/// Keeps what lies within the unit square of a convex polygon whose corners are relative to `site`.
void clip_to_square(std::vector<glm::dvec2>& corners, std::vector<glm::dvec2>& next, glm::dvec2 site) {
  for (int axis = 0; axis < 2; ++axis) {
    for (const double sign : {-1.0, 1.0}) {  // sign * coordinate <= limit
      const double limit = sign < 0 ? site[axis] : 1 - site[axis];
      const auto beyond = [&](glm::dvec2 c) { return sign * c[axis] - limit; };
      next.clear();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 a = corners[k], b = corners[(k + 1) % corners.size()];
        const double at_a = beyond(a), at_b = beyond(b);
        if (at_a <= 0) next.push_back(a);
        if ((at_a > 0) != (at_b > 0)) next.push_back(a + (b - a) * (at_a / (at_a - at_b)));
      }
      corners.swap(next);
    }
  }
}

/// Cells of points in the square, each point with its images `period` apart. An image is at least period - 1
/// away from the square: it can take part in a cell only where that has a corner as far from its own site.
class SquareCells {
 public:
  SquareCells(const Points& points, double period)
      : points_(points), period_(period), diagram_(shrunk(points, period)) {}

  /// The cell of point i into scratch.corners, relative to the point. False where an image may have had a
  /// part in it.
  bool cut(std::size_t i, PeriodicVoronoi::Scratch& scratch) const {
    diagram_.cut(i, scratch);
    for (glm::dvec2& c : scratch.corners) c *= period_;
    clip_to_square(scratch.corners, scratch.next, points_[i]);
    // With a period of 2 every place of the square is nearer to each point than to that point's images.
    return period_ == 2 || farthest(scratch.corners) < period_ - 1;
  }

 private:
  static Points shrunk(Points points, double period) {
    for (glm::dvec2& p : points) p = (p + (period - 1) / 2) / period;
    return points;
  }
  const Points& points_;
  double period_;
  PeriodicVoronoi diagram_;
};

}  // namespace

TorusCells torus_cells(const Points& points) {
  const std::vector<double> zeros(points.size());
  TorusCells cells{zeros, zeros, zeros, zeros};
  const PeriodicVoronoi diagram(points);
  PeriodicVoronoi::Scratch scratch;
  for (const std::uint32_t i : diagram.order()) {
    diagram.cut(i, scratch);
    glm::dvec2 centroid;
    integrate_polygon(scratch.corners, cells.areas[i], centroid, cells.second_moments[i]);
    cells.off_centre[i] = cells.areas[i] * glm::length(centroid);
    cells.reach[i] = 2 * farthest(scratch.corners);
  }
  return cells;
}

CellSums torus_sums(const TorusCells& cells) {
  return {cells.areas, std::accumulate(cells.second_moments.begin(), cells.second_moments.end(), 0.0),
          std::accumulate(cells.off_centre.begin(), cells.off_centre.end(), 0.0)};
}

CellSums square_sums(const Points& points, const TorusCells& cells) {
  // Away from the sides a cell is that of the torus. The others are cut again, with the images so far off
  // that they do no harm: a little first, since a diagram of points that fill its torus is faster.
  CellSums sums{cells.areas, 0, 0};
  const SquareCells close(points, std::min(2.0, 1 + 3 / std::sqrt(static_cast<double>(points.size()))));
  std::optional<SquareCells> far;
  PeriodicVoronoi::Scratch scratch;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 p = points[i];
    if (std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y)) > cells.reach[i]) {
      sums.energy += cells.second_moments[i];
      sums.off_centre += cells.off_centre[i];
      continue;
    }
    if (!close.cut(i, scratch)) {
      if (!far) far.emplace(points, 2.0);
      far->cut(i, scratch);
    }
    double second_moment;
    glm::dvec2 centroid;
    integrate_polygon(scratch.corners, sums.areas[i], centroid, second_moment);
    sums.energy += second_moment;
    sums.off_centre += sums.areas[i] * glm::length(centroid);
  }
  return sums;
}

double second_derivative_bound(const CellSums& cells, double gradient, double hessian) {
  return hessian * cells.energy / 2 + gradient * cells.off_centre;
}

}  // namespace capcon::integrate
