#include "tiling/power_cell.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace capcon {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr int kMaxCorners = 64;

// A convex polygon; wall[i] is the index of the neighbour behind the side from corner i to corner i + 1.
struct Polygon {
  std::array<glm::dvec2, kMaxCorners> corner;
  std::array<std::uint32_t, kMaxCorners> wall;
  int size = 0;

  void add(glm::dvec2 p, std::uint32_t w) {
    assert(size < kMaxCorners);
    corner[size] = p;
    wall[size++] = w;
  }
};

// Keeps what lies on the side dot(x, normal) <= bound.
void clip(const Polygon& from, Polygon& to, glm::dvec2 normal, double bound, std::uint32_t wall) {
  to.size = 0;
  for (int i = 0; i < from.size; ++i) {
    const glm::dvec2 p = from.corner[i], q = from.corner[i + 1 == from.size ? 0 : i + 1];
    const double dp = glm::dot(p, normal) - bound, dq = glm::dot(q, normal) - bound;
    if (dp <= 0) to.add(p, from.wall[i]);
    if ((dp <= 0) != (dq <= 0)) to.add(p + (q - p) * (dp / (dp - dq)), dp <= 0 ? wall : from.wall[i]);
  }
}

double radius2(const Polygon& polygon) {
  double r = 0;
  for (int i = 0; i < polygon.size; ++i) r = std::max(r, glm::dot(polygon.corner[i], polygon.corner[i]));
  return r;
}

void integrate(const Polygon& polygon, const std::vector<Neighbour>& neighbours, PowerCell& cell) {
  cell.area = cell.second_moment = 0;
  cell.centroid = {0, 0};
  cell.walls.clear();
  for (int i = 0; i < polygon.size; ++i) {
    const glm::dvec2 p = polygon.corner[i], q = polygon.corner[i + 1 == polygon.size ? 0 : i + 1];
    const double twice = p.x * q.y - p.y * q.x;  // triangle of the site and this side
    cell.area += twice / 2;
    cell.centroid += (p + q) * (twice / 6);
    cell.second_moment += (glm::dot(p, p) + glm::dot(p, q) + glm::dot(q, q)) * (twice / 12);
    if (polygon.wall[i] != kNone) {
      const Neighbour& n = neighbours[polygon.wall[i]];
      cell.walls.push_back({n.site, std::sqrt(glm::dot(q - p, q - p) / n.distance2) / 2});
    }
  }
  if (cell.area > 0) cell.centroid /= cell.area;
}

}  // namespace

void clip_power_cell(const std::vector<Neighbour>& neighbours, double own_weight,
                     const std::vector<double>& weights, PowerCell& cell, const SiteBox& box) {
  Polygon a, b;
  Polygon *now = &a, *next = &b;
  now->add(box.low, kNone);
  now->add({box.high.x, box.low.y}, kNone);
  now->add(box.high, kNone);
  now->add({box.low.x, box.high.y}, kNone);
  double reach2 = 2;
  for (std::uint32_t k = 0; k < neighbours.size() && now->size > 0; ++k) {
    const Neighbour& n = neighbours[k];
    const double bound = (n.distance2 + own_weight - weights[n.site]) / 2;
    if (bound > 0 && bound * bound >= reach2 * n.distance2) continue;  // beyond the farthest corner
    clip(*now, *next, n.offset, bound, k);
    std::swap(now, next);
    reach2 = radius2(*now);
  }
  integrate(*now, neighbours, cell);
}

}  // namespace capcon
