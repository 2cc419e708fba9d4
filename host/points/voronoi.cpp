#include "points/voronoi.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace capcon {

namespace {

/// More sites than this in the rings looked at so far: the grid is crowded, the tree does better.
constexpr std::uint32_t kCrowd = 200;

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Keeps the part of the polygon that is nearer to the origin than to d. Returns whether anything was cut
/// off.
bool clip(std::vector<glm::dvec2>& corners, std::vector<glm::dvec2>& next, glm::dvec2 d) {
  const double limit = 0.5 * glm::dot(d, d);
  bool beyond = false;
  for (const glm::dvec2& c : corners) beyond |= glm::dot(c, d) > limit;
  if (!beyond) return false;
  next.clear();
  glm::dvec2 a = corners.back();
  double side_a = glm::dot(a, d) - limit;
  for (const glm::dvec2& b : corners) {
    const double side_b = glm::dot(b, d) - limit;
    if ((side_a > 0) != (side_b > 0)) next.push_back(a + (b - a) * (side_a / (side_a - side_b)));
    if (side_b <= 0) next.push_back(b);
    a = b;
    side_a = side_b;
  }
  corners.swap(next);
  return true;
}

/// Brings x into [0, side); returns the number of periods that took. Without a division: x is never far off.
int wrap(int& x, int side) {
  int periods = 0;
  for (; x < 0; x += side) --periods;
  for (; x >= side; x -= side) ++periods;
  return periods;
}

double farthest_corner2(const std::vector<glm::dvec2>& corners) {
  double farthest = 0;
  for (const glm::dvec2& c : corners) farthest = std::max(farthest, glm::dot(c, c));
  return farthest;
}

/// A site inside the box can cut the polygon only if one of the polygon's corners is nearer to it than to the
/// origin.
bool box_can_cut(const std::vector<glm::dvec2>& corners, glm::dvec2 low, glm::dvec2 high) {
  for (const glm::dvec2& c : corners) {
    if (box_distance2(c, low, high) < glm::dot(c, c)) return true;
  }
  return false;
}

}  // namespace

PeriodicVoronoi::PeriodicVoronoi(const Points& points) : sites_(points), twin_(points.size(), Twin::kNone) {
  // Multiples of 2^-53 have exact differences, wrapped or not: no two neighbours disagree on where their
  // bisector is, and "the same place" is a plain comparison. (Only coordinates below 1/2 can change, by less
  // than 2^-54.)
  for (glm::dvec2& s : sites_) {
    s.x = std::nearbyint(s.x * 0x1p53) * 0x1p-53;
    s.y = std::nearbyint(s.y * 0x1p53) * 0x1p-53;
  }
  side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(points.size()) / 1.5)));
  const std::size_t cells = static_cast<std::size_t>(side_) * side_;
  const auto cell_of = [&](glm::dvec2 p) {
    return static_cast<std::size_t>(static_cast<int>(p.y * side_)) * side_ + static_cast<int>(p.x * side_);
  };
  std::vector<std::uint32_t> fill(cells + 1, 0);
  for (const glm::dvec2& s : sites_) ++fill[cell_of(s) + 1];
  for (std::size_t c = 0; c < cells; ++c) fill[c + 1] += fill[c];
  std::vector<std::uint32_t> all(sites_.size());
  {
    std::vector<std::uint32_t> at(fill.begin(), fill.end() - 1);
    for (std::size_t i = 0; i < sites_.size(); ++i)
      all[at[cell_of(sites_[i])]++] = static_cast<std::uint32_t>(i);
  }
  start_.reserve(cells + 1);
  order_.reserve(sites_.size());
  std::uint32_t crowd = 0;
  std::size_t empty = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    start_.push_back(static_cast<std::uint32_t>(order_.size()));
    const auto begin = all.begin() + fill[c];
    const auto end = all.begin() + fill[c + 1];
    std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
      const glm::dvec2 p = sites_[a], q = sites_[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
    for (auto i = begin; i != end; ++i) {
      if (i != begin && sites_[*i] == sites_[*(i - 1)]) {
        twin_[*i] = Twin::kLater;
        twin_[order_.back()] = Twin::kFirst;
      } else {
        order_.push_back(*i);
      }
    }
    empty += begin == end;
    crowd = std::max(crowd, static_cast<std::uint32_t>(order_.size()) - start_.back());
  }
  start_.push_back(static_cast<std::uint32_t>(order_.size()));
  positions_.reserve(order_.size());
  for (const std::uint32_t i : order_) positions_.push_back(sites_[i]);
  // Even or random points stay clear of both limits (random ones leave 22 % of the grid empty).
  if (crowd > 12 || 2 * empty > cells) tree_ = KdTree(sites_, order_);
  for (std::uint32_t i = 0; i < twin_.size(); ++i) {
    if (twin_[i] == Twin::kLater) order_.push_back(i);
  }
}

double PeriodicVoronoi::cut(std::size_t index, Scratch& scratch) const {
  const auto i = static_cast<std::uint32_t>(index);
  auto& corners = scratch.corners;
  corners.clear();
  if (twin_[i] == Twin::kLater) return 0;
  corners = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const glm::dvec2 site = sites_[i];
  const int home_x = static_cast<int>(site.x * side_);
  const int home_y = static_cast<int>(site.y * side_);
  const double width = 1.0 / side_;
  // The distance from the site to the border of its own grid cell: what lies beyond ring r is at least r
  // widths + this.
  const double margin = std::min(std::min(site.x - home_x * width, (home_x + 1) * width - site.x),
                                 std::min(site.y - home_y * width, (home_y + 1) * width - site.y));
  double nearest = twin_[i] == Twin::kFirst ? 0 : 1;
  double reach2 = 4 * farthest_corner2(corners);
  std::uint32_t seen = 0;
  const auto visit = [&](int x, int y) {
    const glm::dvec2 shift(wrap(x, side_), wrap(y, side_));
    const std::size_t cell = static_cast<std::size_t>(y) * side_ + x;
    for (std::uint32_t e = start_[cell]; e < start_[cell + 1]; ++e) {
      const glm::dvec2 d = (positions_[e] - site) + shift;
      const double distance2 = glm::dot(d, d);
      if (distance2 >= reach2 || order_[e] == i) continue;
      nearest = std::min(nearest, distance2);
      if (clip(corners, scratch.next, d)) reach2 = 4 * farthest_corner2(corners);
    }
  };
  const auto load = [&](int x, int y) {
    wrap(x, side_);
    wrap(y, side_);
    const std::size_t cell = static_cast<std::size_t>(y) * side_ + x;
    seen += start_[cell + 1] - start_[cell];
  };
  // No image farther than 1 along an axis can cut: its neighbour one period nearer is nearer to all of the
  // unit square.
  for (int ring = 0; ring <= side_ + 1; ++ring) {
    const double safe = (ring - 1) * width + margin;
    if (ring > 0 && safe > 0 && safe * safe >= reach2) break;
    const auto walk = [&](const auto& act) {
      if (ring == 0) return act(home_x, home_y);
      for (int k = -ring; k <= ring; ++k) {
        act(home_x + k, home_y - ring);
        act(home_x + k, home_y + ring);
      }
      for (int k = -ring + 1; k < ring; ++k) {
        act(home_x - ring, home_y + k);
        act(home_x + ring, home_y + k);
      }
    };
    if (!tree_.empty()) {
      walk(load);
      if (seen > kCrowd || ring > 6) return cut_rest_by_tree(i, scratch, nearest);
    }
    walk(visit);
  }
  return nearest;
}

double PeriodicVoronoi::cut_rest_by_tree(std::uint32_t i, Scratch& scratch, double nearest) const {
  const glm::dvec2 site = sites_[i];
  auto& queue = scratch.queue;
  const auto later = [](const KdTree::Entry& a, const KdTree::Entry& b) {
    return a.distance2 != b.distance2 ? a.distance2 > b.distance2 : a.node > b.node;
  };
  const auto push = [&](std::uint32_t n, glm::dvec2 shift) {
    const KdTree::Node& node = tree_.nodes()[n];
    const glm::dvec2 low = (node.low - site) + shift, high = (node.high - site) + shift;
    if (!box_can_cut(scratch.corners, low, high)) return;
    queue.push_back({box_distance2(glm::dvec2(0), low, high), n, shift});
    std::push_heap(queue.begin(), queue.end(), later);
  };
  queue.clear();
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) push(0, {x, y});
  }
  while (!queue.empty()) {
    std::pop_heap(queue.begin(), queue.end(), later);
    const KdTree::Entry entry = queue.back();
    queue.pop_back();
    const KdTree::Node& node = tree_.nodes()[entry.node];
    if (!box_can_cut(scratch.corners, (node.low - site) + entry.shift, (node.high - site) + entry.shift))
      continue;
    if (node.left != 0) {
      push(node.left, entry.shift);
      push(node.left + 1, entry.shift);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t j = tree_.items()[k];
      if (j == i) continue;
      const glm::dvec2 d = (sites_[j] - site) + entry.shift;
      nearest = std::min(nearest, glm::dot(d, d));
      clip(scratch.corners, scratch.next, d);
    }
  }
  return nearest;
}

void integrate_polygon(const std::vector<glm::dvec2>& corners, double& area, glm::dvec2& centroid,
                       double& second_moment) {
  area = second_moment = 0;
  centroid = glm::dvec2(0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec2 p = corners[k], q = corners[k + 1 < corners.size() ? k + 1 : 0];
    const double triangle = 0.5 * cross(p, q);
    area += triangle;
    centroid += triangle / 3 * (p + q);
    second_moment += triangle / 6 * (glm::dot(p, p) + glm::dot(p, q) + glm::dot(q, q));
  }
  if (area > 0) centroid /= area;
}

}  // namespace capcon
