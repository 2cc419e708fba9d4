#include "points/dynamic_voronoi.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace capcon {

namespace {

using Image = DynamicVoronoi::Image;

constexpr double kRounding = 1e-9;  // what is below this part of a distance may be nothing

/// `step` as seen from `from`: periods add up.
Image moved(Image step, Image from) {
  return {step.site, static_cast<std::int16_t>(step.x + from.x), static_cast<std::int16_t>(step.y + from.y)};
}

Image reversed(Image image, std::uint32_t site) {
  return {site, static_cast<std::int16_t>(-image.x), static_cast<std::int16_t>(-image.y)};
}

}  // namespace

glm::dvec2 DynamicVoronoi::offset(std::uint32_t i, Image image) const {
  return (positions_[image.site] - positions_[i]) + glm::dvec2(image.x, image.y);
}

void DynamicVoronoi::set_whole(Cell& cell, std::uint32_t i) {
  cell.assign({{{-0.5, -0.5}, {i, 0, -1}},
               {{0.5, -0.5}, {i, 1, 0}},
               {{0.5, 0.5}, {i, 0, 1}},
               {{-0.5, 0.5}, {i, -1, 0}}});
}

DynamicVoronoi::Cut DynamicVoronoi::clip(Cell& cell, glm::dvec2 d, Image image) {
  const double half = 0.5 * glm::dot(d, d);
  const std::size_t count = cell.size();
  heights_.resize(count + 1);
  double highest = -half;
  for (std::size_t k = 0; k < count; ++k) {
    heights_[k] = glm::dot(cell[k].corner, d) - half;
    highest = std::max(highest, heights_[k]);
  }
  if (std::abs(highest) < kRounding * half) four_on_a_circle_ = true;
  if (highest <= 0) return highest > -kRounding * half ? Cut::kTouch : Cut::kNone;
  heights_[count] = heights_[0];
  clipped_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const double here = heights_[k], there = heights_[k + 1];
    const auto crossing = [&] {
      const glm::dvec2 a = cell[k].corner, b = cell[k + 1 < count ? k + 1 : 0].corner;
      return a + (b - a) * (here / (here - there));
    };
    if (here < 0) {
      clipped_.push_back(cell[k]);
      if (there > 0) clipped_.push_back({crossing(), image});
    } else if (here == 0) {
      clipped_.push_back({cell[k].corner, there > 0 ? image : cell[k].across});
    } else if (there < 0) {
      clipped_.push_back({crossing(), cell[k].across});
    }
  }
  cell.swap(clipped_);
  return Cut::kCut;
}

DynamicVoronoi::Image DynamicVoronoi::nearest(glm::dvec2 p, std::uint32_t near) const {
  const auto distance2 = [&](Image image) {
    const glm::dvec2 d = (positions_[image.site] - p) + glm::dvec2(image.x, image.y);
    return glm::dot(d, d);
  };
  const glm::dvec2 periods = glm::round(p - positions_[near]);
  Image best{near, static_cast<std::int16_t>(periods.x), static_cast<std::int16_t>(periods.y)};
  double best2 = distance2(best);
  // From cell to cell downhill: in a Voronoi diagram only the nearest site has no nearer neighbour.
  for (bool better = true; better;) {
    better = false;
    const Image here = best;
    for (const Edge& edge : cells_[here.site]) {
      const Image next = moved(edge.across, here);
      const double next2 = distance2(next);
      if (next2 < best2) best = next, best2 = next2, better = true;
    }
  }
  return best;
}

bool DynamicVoronoi::walk_around(std::uint32_t i, Image start) {
  // The bisector with a neighbour leaves the neighbour's cell over the edge towards the next one (Green and
  // Sibson, "Computing Dirichlet tessellations in the plane", 1978).
  constexpr int kMost = 64;
  Cell& cell = cells_[i];
  cell.clear();
  Image image = start;
  for (int step = 0; step < kMost; ++step) {
    const Cell& other = cells_[image.site];
    const glm::dvec2 d = offset(i, image);
    const double half = 0.5 * glm::dot(d, d);
    const std::size_t count = other.size();
    const auto height = [&](std::size_t k) { return -glm::dot(other[k].corner, d) - half; };
    const Edge *in = nullptr, *out = nullptr;
    glm::dvec2 begin{0};
    double here = height(0);
    const double first = here;
    for (std::size_t k = 0; k < count; ++k) {
      if (std::abs(here) < kRounding * half) return false;
      const double there = k + 1 < count ? height(k + 1) : first;
      if (here < 0 && there > 0) in = &other[k];
      if (here > 0 && there < 0) {
        out = &other[k];
        const glm::dvec2 a = out->corner, b = other[k + 1 < count ? k + 1 : 0].corner;
        begin = d + a + (b - a) * (here / (here - there));
      }
      here = there;
    }
    if (in == nullptr || out == nullptr) return false;
    if (!(std::abs(begin.x) < 0.5 && std::abs(begin.y) < 0.5)) return false;  // its own images cut it too
    cell.push_back({begin, image});
    image = moved(in->across, image);
    if (image == start) return true;
  }
  return false;
}

void DynamicVoronoi::search_around(std::uint32_t i, Image start) {
  // The sites around the new cell are connected: go on to the neighbours of all that cut or touch.
  Cell& cell = cells_[i];
  set_whole(cell, i);
  seen_.assign(1, start);
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const Image image = seen_[k];
    if (clip(cell, offset(i, image), image) == Cut::kNone) continue;
    for (const Edge& edge : cells_[image.site]) {
      if (edge.across.site == i) continue;
      const Image next = moved(edge.across, image);
      if (std::find(seen_.begin(), seen_.end(), next) == seen_.end()) seen_.push_back(next);
    }
  }
}

void DynamicVoronoi::insert(std::uint32_t i, glm::dvec2 p, std::uint32_t near) {
  positions_[i] = p;
  changed_.assign(1, i);
  Cell& cell = cells_[i];
  if (near == i) {
    set_whole(cell, i);
    return;
  }
  const Image start = nearest(p, near);
  if (!walk_around(i, start)) search_around(i, start);
  for (const Edge& edge : cell) {
    const std::uint32_t q = edge.across.site;
    if (q == i) continue;
    const Image back = reversed(edge.across, i);
    clip(cells_[q], offset(q, back), back);
    if (std::find(changed_.begin(), changed_.end(), q) == changed_.end()) changed_.push_back(q);
  }
}

void DynamicVoronoi::remove(std::uint32_t i) {
  removed_ = i;
  changed_.clear();
  hole_.swap(cells_[i]);
  cells_[i].clear();
  const auto consider = [&](std::uint32_t q) {
    if (q == i || std::find(changed_.begin(), changed_.end(), q) != changed_.end()) return;
    const Cell& cell = cells_[q];
    if (std::any_of(cell.begin(), cell.end(), [&](const Edge& edge) { return edge.across.site == i; }))
      changed_.push_back(q);
  };
  for (const Edge& edge : hole_) consider(edge.across.site);
  if (four_on_a_circle_) {  // over an edge of length about 0 a cell may list i that i does not list
    for (const Edge& edge : hole_) {
      for (const Edge& second : cells_[edge.across.site]) consider(second.across.site);
    }
  }
  if (before_.size() < changed_.size()) before_.resize(changed_.size());
  for (std::size_t k = 0; k < changed_.size(); ++k) heal(changed_[k], before_[k]);
}

bool DynamicVoronoi::without_edge(std::uint32_t q, Cell& cell) const {
  // The lines on both sides of the edge go on until they meet.
  const Cell& old = cells_[q];
  const std::size_t count = old.size();
  std::size_t k = count;
  for (std::size_t e = 0; e < count; ++e) {
    if (old[e].across.site != removed_) continue;
    if (k < count) return false;
    k = e;
  }
  const std::size_t next = k + 1 < count ? k + 1 : 0;
  const glm::dvec2 a = offset(q, old[k > 0 ? k - 1 : count - 1].across), b = offset(q, old[next].across);
  const double cross = a.x * b.y - a.y * b.x;
  if (!(cross > 0.1 * std::sqrt(glm::dot(a, a) * glm::dot(b, b)))) return false;  // never, or far away
  const double half_a = 0.5 * glm::dot(a, a), half_b = 0.5 * glm::dot(b, b);
  const glm::dvec2 meeting = glm::dvec2(half_a * b.y - half_b * a.y, half_b * a.x - half_a * b.x) / cross;
  if (!(std::abs(meeting.x) < 0.5 && std::abs(meeting.y) < 0.5)) return false;
  cell.clear();
  for (std::size_t e = 0; e < count; ++e) {
    if (e != k) cell.push_back({e == next ? meeting : old[e].corner, old[e].across});
  }
  return true;
}

void DynamicVoronoi::heal(std::uint32_t q, Cell& cell) {
  const auto cut = [&](Image image) {
    if (image.site == removed_ || image == Image{q, 0, 0}) return;
    if (std::none_of(cell.begin(), cell.end(), [&](const Edge& edge) { return edge.across == image; }))
      clip(cell, offset(q, image), image);
  };
  Cell& old = cells_[q];
  if (!without_edge(q, cell)) {
    set_whole(cell, q);
    for (const Edge& edge : old) cut(edge.across);
  }
  // New neighbours can only be those with which q shares the hole.
  for (const Edge& edge : old) {
    if (edge.across.site != removed_) continue;
    for (const Edge& rim : hole_) cut(moved(rim.across, edge.across));
  }
  cell.swap(old);
}

void DynamicVoronoi::undo_remove() {
  for (std::size_t k = 0; k < changed_.size(); ++k) cells_[changed_[k]].swap(before_[k]);
  cells_[removed_].swap(hole_);
  changed_.push_back(removed_);
}

}  // namespace capcon
