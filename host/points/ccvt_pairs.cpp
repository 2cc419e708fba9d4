#include "points/ccvt_pairs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace capcon {

namespace {

glm::dvec2 wrapped(glm::dvec2 d) {
  return d - glm::round(d);
}

}  // namespace

CcvtPairs::Circle CcvtPairs::circle_of(const CcvtSite& site) {
  const double x = site.centre.x + site.x, y = site.centre.y + site.y;
  glm::dvec2 centre = glm::dvec2(x, y) * 0x1p-32;
  centre -= glm::floor(centre);
  return {centre, (site.reach + std::hypot(site.x, site.y)) * 0x1p-32, 0};
}

bool CcvtPairs::is_stale(const CcvtCells& cells) const {
  if (circles_.size() != cells.size()) return true;
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    const Circle now = circle_of(cells.sites[i]);
    const double moved = glm::length(wrapped(now.centre - circles_[i].centre));
    if (moved + now.radius - circles_[i].radius > circles_[i].slack) return true;
  }
  return false;
}

bool CcvtPairs::refresh(const CcvtCells& cells, std::uint32_t time) {
  if (!is_stale(cells)) return false;
  const double slack = 0.1 / std::sqrt(static_cast<double>(cells.size()));
  circles_.resize(cells.size());
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    circles_[i] = circle_of(cells.sites[i]);
    circles_[i].slack = slack;
  }
  find();
  for (Pair& pair : pairs_) pair.checked = time;
  batch_up();
  return true;
}

void CcvtPairs::find() {
  struct Entry {
    glm::dvec2 centre;
    double reach;
    std::uint32_t index;
  };
  pairs_.clear();
  const std::size_t n = circles_.size();
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(n) / 2)));
  const auto cell_of = [&](double v) { return std::min(side - 1, static_cast<int>(v * side)); };
  std::vector<std::uint32_t> start(static_cast<std::size_t>(side) * side + 1, 0), home(n);
  for (std::size_t i = 0; i < n; ++i) {
    home[i] =
        static_cast<std::uint32_t>(cell_of(circles_[i].centre.y) * side + cell_of(circles_[i].centre.x));
    ++start[home[i] + 1];
  }
  for (std::size_t c = 0; c + 1 < start.size(); ++c) start[c + 1] += start[c];
  std::vector<Entry> entries(n);
  {
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i) {
      entries[at[home[i]]++] = {circles_[i].centre, circles_[i].radius + circles_[i].slack, i};
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::dvec2 centre = circles_[i].centre;
    const double reach = circles_[i].radius + circles_[i].slack;
    const auto look = [&](int x, int y, glm::dvec2 shift, bool wrap) {
      const std::size_t cell = static_cast<std::size_t>(y) * side + x;
      for (std::uint32_t e = start[cell]; e < start[cell + 1]; ++e) {
        const Entry& other = entries[e];
        // A pair is found from its larger circle, so that twice the radius is as far as one has to look.
        if (other.reach > reach || (other.reach == reach && other.index >= i)) continue;
        glm::dvec2 d = other.centre - centre + shift;
        if (wrap) d = wrapped(d);
        if (glm::dot(d, d) < (reach + other.reach) * (reach + other.reach)) {
          pairs_.push_back({std::min(i, other.index), std::max(i, other.index), 0});
        }
      }
    };
    const int x = static_cast<int>(home[i]) % side, y = static_cast<int>(home[i]) / side;
    const int rings = static_cast<int>(std::min<double>(2 * reach * side + 1, side));
    if (2 * rings + 1 >= side) {  // all around the torus: every cell once
      for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) look(column, row, glm::dvec2(0), true);
      }
      continue;
    }
    for (int row = y - rings; row <= y + rings; ++row) {
      const int around_y = row < 0 ? -1 : row >= side ? 1 : 0;
      for (int column = x - rings; column <= x + rings; ++column) {
        const int around_x = column < 0 ? -1 : column >= side ? 1 : 0;
        look(column - around_x * side, row - around_y * side, {around_x, around_y}, false);
      }
    }
  }
}

void CcvtPairs::batch_up() {
  // Each pair takes the first batch in which neither site is busy. Sites with more than 63 pairs (only in a
  // wild start) share the last batches, one pair each.
  std::vector<std::uint64_t> busy(circles_.size(), 0);
  std::vector<std::uint32_t> batch(pairs_.size());
  std::vector<std::size_t> count;
  std::uint32_t next = 64;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const std::uint64_t taken = busy[pairs_[p].i] | busy[pairs_[p].j];
    batch[p] = static_cast<std::uint32_t>(std::countr_one(taken));
    if (batch[p] < 64) {
      busy[pairs_[p].i] |= 1ull << batch[p];
      busy[pairs_[p].j] |= 1ull << batch[p];
    } else {
      batch[p] = next++;
    }
    if (batch[p] >= count.size()) count.resize(batch[p] + 1, 0);
    ++count[batch[p]];
  }
  start_.assign(1, 0);
  for (const std::size_t c : count) start_.push_back(start_.back() + c);
  std::vector<Pair> sorted(pairs_.size());
  std::vector<std::size_t> at(start_.begin(), start_.end() - 1);
  for (std::size_t p = 0; p < pairs_.size(); ++p) sorted[at[batch[p]]++] = pairs_[p];
  pairs_.swap(sorted);
}

}  // namespace capcon
