#include "points/bounded_cells.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "points/measure.h"
#include "points/voronoi.h"

namespace capcon {

namespace {

using Polygon = std::vector<glm::dvec2>;

/// Keeps what is on the side of `limit` that `sign` tells.
void cut(Polygon& polygon, int axis, double limit, double sign) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 a = polygon[k], b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    const double in_a = sign * (limit - a[axis]), in_b = sign * (limit - b[axis]);
    if (in_a >= 0) kept.push_back(a);
    if ((in_a > 0 && in_b < 0) || (in_a < 0 && in_b > 0))
      kept.push_back(a + (b - a) * (in_a / (in_a - in_b)));
  }
  polygon.swap(kept);
}

CellMoments in_square(Polygon polygon, glm::dvec2 site) {
  for (const int axis : {0, 1}) {
    cut(polygon, axis, -site[axis], -1);
    cut(polygon, axis, 1 - site[axis], 1);
  }
  CellMoments moments;
  double second_moment;
  integrate_polygon(polygon, moments.area, moments.centroid, second_moment);
  moments.centroid = moments.area > 0 ? moments.centroid + site : site;
  return moments;
}

/// Sums of area and first moments over triangles and sectors between the disk's centre and the polygon's
/// edges.
struct DiskSums {
  static constexpr double kRadius = 0.5;
  double area = 0;
  glm::dvec2 moment{0};

  void add_triangle(glm::dvec2 p, glm::dvec2 q) {
    const double a = 0.5 * (p.x * q.y - p.y * q.x);
    area += a;
    moment += a / 3 * (p + q);
  }
  void add_sector(glm::dvec2 p, glm::dvec2 q) {
    const double angle = std::atan2(p.x * q.y - p.y * q.x, glm::dot(p, q));
    const glm::dvec2 from = p / glm::length(p), to = q / glm::length(q);
    area += angle / 2 * kRadius * kRadius;
    moment += kRadius * kRadius * kRadius / 3 * glm::dvec2(to.y - from.y, from.x - to.x);
  }
  /// Inside the circle the edge itself bounds the cell, outside the circle does.
  void add_edge(glm::dvec2 p, glm::dvec2 q) {
    const glm::dvec2 d = q - p;
    const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - kRadius * kRadius;
    const double root2 = b * b - a * c;
    if (a == 0) return;
    if (root2 <= 0) return add_sector(p, q);
    const double root = std::sqrt(root2);
    const double enter = std::clamp((-b - root) / a, 0.0, 1.0), leave = std::clamp((-b + root) / a, 0.0, 1.0);
    const glm::dvec2 in = p + d * enter, out = p + d * leave;
    if (enter > 0) add_sector(p, in);
    if (leave > enter) add_triangle(in, out);
    if (leave < 1) add_sector(out, q);
  }
};

CellMoments in_disk(const Polygon& polygon, glm::dvec2 site) {
  const glm::dvec2 middle(0.5);
  DiskSums sums;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sums.add_edge(polygon[k] + site - middle, polygon[k + 1 < polygon.size() ? k + 1 : 0] + site - middle);
  return {sums.area, sums.area > 0 ? middle + sums.moment / sums.area : site};
}

}  // namespace

std::vector<CellMoments> bounded_cells(const Points& points, Domain domain) {
  assert(domain != Domain::kTorus);
  // At half the size, no way around the torus is shorter than the straight one: cells are the plane's, once
  // cut off.
  Points half;
  for (const glm::dvec2& p : points) half.push_back(0.5 * p);
  const std::vector<VoronoiCell> cells = voronoi_cells(half);
  std::vector<CellMoments> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Polygon polygon = cells[i].corners;
    for (glm::dvec2& corner : polygon) corner *= 2;
    result.push_back(domain == Domain::kSquare ? in_square(polygon, points[i]) : in_disk(polygon, points[i]));
  }
  return result;
}

}  // namespace capcon
