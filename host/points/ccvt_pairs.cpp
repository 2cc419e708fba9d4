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
  return {glm::dvec2(x, y) * 0x1p-32, (site.reach + std::hypot(site.x, site.y)) * 0x1p-32, 0};
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
  pairs_.clear();
  const std::size_t n = circles_.size();
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(n) / 2)));
  const auto cell_of = [&](double v) {
    return std::min(side - 1, static_cast<int>((v - std::floor(v)) * side));
  };
  std::vector<std::uint32_t> start(static_cast<std::size_t>(side) * side + 1, 0), order(n), home(n);
  for (std::size_t i = 0; i < n; ++i) {
    home[i] =
        static_cast<std::uint32_t>(cell_of(circles_[i].centre.y) * side + cell_of(circles_[i].centre.x));
    ++start[home[i] + 1];
  }
  for (std::size_t c = 0; c + 1 < start.size(); ++c) start[c + 1] += start[c];
  {
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i) order[at[home[i]]++] = i;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const Circle& a = circles_[i];
    const double radius = a.radius + a.slack;
    const int home_x = static_cast<int>(home[i]) % side, home_y = static_cast<int>(home[i]) / side;
    // A pair is found from its larger circle, so twice its radius is as far as one has to look.
    const int rings = std::min(side / 2 + 1, static_cast<int>(2 * radius * side) + 1);
    const bool everywhere = 2 * rings + 1 >= side;
    for (int row = everywhere ? 0 : home_y - rings; row <= (everywhere ? side - 1 : home_y + rings); ++row) {
      for (int column = everywhere ? 0 : home_x - rings; column <= (everywhere ? side - 1 : home_x + rings);
           ++column) {
        const std::size_t cell =
            static_cast<std::size_t>((row + side) % side) * side + (column + side) % side;
        for (std::uint32_t e = start[cell]; e < start[cell + 1]; ++e) {
          const std::uint32_t j = order[e];
          const Circle& b = circles_[j];
          const double other = b.radius + b.slack;
          if (other > radius || (other == radius && j >= i)) continue;
          const glm::dvec2 d = wrapped(b.centre - a.centre);
          if (glm::dot(d, d) < (radius + other) * (radius + other)) {
            pairs_.push_back({std::min(i, j), std::max(i, j), 0});
          }
        }
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
