#include "points/power_cell.h"

#include <glm/geometric.hpp>

namespace capcon {

void PowerCell::reset(std::uint32_t site) {
  x_.assign({-0.5, 0.5, 0.5, -0.5});
  y_.assign({-0.5, -0.5, 0.5, 0.5});
  beyond_.assign({{site, 0, -1}, {site, 1, 0}, {site, 0, 1}, {site, -1, 0}});
}

bool PowerCell::cut(glm::dvec2 d, double limit, SiteImage beyond) {
  const std::size_t count = x_.size();
  side_.resize(count);
  std::size_t outside = 0;
  for (std::size_t k = 0; k < count; ++k) {
    side_[k] = x_[k] * d.x + y_[k] * d.y - limit;
    outside += side_[k] > 0;
  }
  if (outside == 0) return false;
  // The same line again, and rounding: it would leave edges of length 0 or halves.
  for (const SiteImage image : beyond_) {
    if (image == beyond) return false;
  }
  next_x_.clear();
  next_y_.clear();
  next_beyond_.clear();
  if (outside < count) {
    const auto after = [&](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
    // What is cut off is one run of corners: from `first`, whose forerunner stays, to `last`.
    std::size_t before = 0;
    while (side_[before] > 0 || !(side_[after(before)] > 0)) ++before;
    const std::size_t first = after(before);
    std::size_t last = first;
    while (side_[after(last)] > 0) last = after(last);
    const std::size_t behind = after(last);
    const auto push = [&](double x, double y, SiteImage image) {
      next_x_.push_back(x);
      next_y_.push_back(y);
      next_beyond_.push_back(image);
    };
    for (std::size_t k = behind; k != first; k = after(k)) push(x_[k], y_[k], beyond_[k]);
    const double u = side_[before] / (side_[before] - side_[first]);
    push(x_[before] + (x_[first] - x_[before]) * u, y_[before] + (y_[first] - y_[before]) * u, beyond);
    const double v = side_[behind] / (side_[behind] - side_[last]);
    push(x_[behind] + (x_[last] - x_[behind]) * v, y_[behind] + (y_[last] - y_[behind]) * v, beyond_[last]);
  }
  x_.swap(next_x_);
  y_.swap(next_y_);
  beyond_.swap(next_beyond_);
  return true;
}

Moments PowerCell::moments() const {
  // About the first corner, which is never far off, by the triangles that the edges span with it.
  Moments sum;
  if (x_.empty()) return sum;
  const glm::dvec2 o = corner(0);
  for (std::size_t k = 1; k + 1 < x_.size(); ++k) {
    const glm::dvec2 p = corner(k) - o, q = corner(k + 1) - o;
    const double area = 0.5 * (p.x * q.y - p.y * q.x);
    sum.area += area;
    sum.first += area / 3 * (p + q);
    sum.second += area / 6 * (glm::dot(p, p) + glm::dot(p, q) + glm::dot(q, q));
  }
  sum.second += 2 * glm::dot(o, sum.first) + glm::dot(o, o) * sum.area;
  sum.first += o * sum.area;
  return sum;
}

}  // namespace capcon
