#include "points/ccvt_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace capcon {

namespace {

constexpr std::uint32_t kLarge = 128;  // capacity from which to keep account
// Blocks of sites whose space points fit into a cache, and do not consist of borders alone.
constexpr std::uint32_t kBlockPoints = 1u << 16, kLeastBlock = 128;
constexpr float kWide = 10;     // slacks; radii are near 7 in the end
constexpr double kUneven = 32;  // sites a grid cell, as a site sees it, from which a tree is faster: even, 3
constexpr float kUnknown = std::numeric_limits<float>::infinity();

float distance(TorusPoint a, TorusPoint b) {
  const auto dx = static_cast<float>(difference(b.x, a.x)), dy = static_cast<float>(difference(b.y, a.y));
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

CcvtPairs::CcvtPairs(std::uint32_t capacity)
    : keeps_account_(capacity >= kLarge), block_(std::max(kLeastBlock, kBlockPoints / capacity)) {}

CcvtPairs::Circle CcvtPairs::circle_of(const CcvtSite& site) {
  const auto x = static_cast<std::int64_t>(site.x), y = static_cast<std::int64_t>(site.y);
  return {{site.centre.x + static_cast<std::uint32_t>(x), site.centre.y + static_cast<std::uint32_t>(y)},
          site.reach + static_cast<float>(std::sqrt(site.x * site.x + site.y * site.y))};
}

bool CcvtPairs::is_settled(const CcvtCells& cells, const Pair& pair) const {
  const CcvtSite& a = cells.sites[pair.i];
  const CcvtSite& b = cells.sites[pair.j];
  const float margin = pair.front.limit - pair.front.most_i - pair.front.most_j;
  const double moved = a.travel + b.travel - pair.travel;
  if (!(margin >= 0)) return false;
  if (!keeps_account_ || moved == 0) return moved == 0;
  // The sites are `moved` away from where they were, as seen from each other, so the direction has turned by
  // an angle of sine at most moved / distance. Across it, two points are no farther apart than `wide`.
  const double dx = difference(b.centre.x, a.centre.x) + b.x - a.x;
  const double dy = difference(b.centre.y, a.centre.y) + b.y - a.y;
  const double distance2 = dx * dx + dy * dy;
  const double wide = a.reach + b.reach + 0.25f * a.inner;
  return 100 * moved * moved <= distance2 &&
         1.05 * (moved * wide) * (moved * wide) <= static_cast<double>(margin) * margin * distance2;
}

void CcvtPairs::note_arrivals(const CcvtCells& cells, std::uint32_t i,
                              const std::vector<CcvtCandidate>& slots, std::uint32_t count,
                              const Pair& than) {
  if (!keeps_account_) return;
  const TorusPoint centre = cells.sites[i].centre;
  for (std::uint32_t e = first_[i]; e < first_[i + 1]; ++e) {
    Pair& pair = pairs_[of_site_[e]];
    if (&pair == &than) continue;
    const bool is_first = pair.i == i;
    float& most = is_first ? pair.front.most_i : pair.front.most_j;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto dx = static_cast<float>(difference(cells.x(i)[slots[k].slot], centre.x));
      const auto dy = static_cast<float>(difference(cells.y(i)[slots[k].slot], centre.y));
      const float key = dx * pair.front.ux + dy * pair.front.uy;
      most = std::max(most, is_first ? key : -key);
    }
  }
}

void CcvtPairs::forget(std::uint32_t i, const Pair* than) {
  if (!keeps_account_) return;
  for (std::uint32_t e = first_[i]; e < first_[i + 1]; ++e) {
    Pair& pair = pairs_[of_site_[e]];
    if (&pair == than) continue;
    (pair.i == i ? pair.front.most_i : pair.front.most_j) = kUnknown;
  }
}

std::vector<std::uint32_t> CcvtPairs::stale_sites(const CcvtCells& cells) {
  const std::size_t n = cells.size();
  slack_ = static_cast<float>(0.1 * 0x1p32 / std::sqrt(static_cast<double>(n)));
  circles_.resize(n);
  std::vector<std::uint32_t> stale, wide;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Circle now = circle_of(cells.sites[i]);
    const Circle& old = circles_[i];
    const float slack = slack_of(old);
    const float grown = distance(now.centre, old.centre) + now.radius - old.radius;
    if (old.radius < 0 || grown > slack || now.radius < old.radius - 3 * slack) {
      stale.push_back(i);
      circles_[i] = now;
    } else if (old.radius > kWide * slack_) {
      wide.push_back(i);
    }
  }
  if (stale.empty()) return stale;
  // Wide circles always look for their pairs themselves: so no other has to look that far.
  stale.insert(stale.end(), wide.begin(), wide.end());
  std::sort(stale.begin(), stale.end());
  return stale;
}

void CcvtPairs::refresh(const CcvtCells& cells) {
  const std::vector<std::uint32_t> stale = stale_sites(cells);
  if (stale.empty()) return;
  std::vector<std::uint8_t> is_stale(cells.size(), 0);
  for (const std::uint32_t i : stale) is_stale[i] = 1;
  std::size_t kept = 0;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (is_stale[pairs_[p].i] || is_stale[pairs_[p].j]) continue;
    pairs_[kept++] = pairs_[p];
  }
  pairs_.resize(kept);
  if (kept == 0) pairs_.shrink_to_fit();  // before the new ones come: wild starts have many
  share_out(find(stale));
}

std::vector<CcvtPairs::Names> CcvtPairs::find(const std::vector<std::uint32_t>& stale) const {
  std::vector<Names> found;
  struct Entry {
    TorusPoint centre;
    float reach;
    std::uint32_t index;
  };
  const std::size_t n = circles_.size();
  const auto side = static_cast<std::uint32_t>(std::max(1.0, std::sqrt(static_cast<double>(n) / 2)));
  const auto cell_of = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(v) * side >> 32);
  };
  std::vector<std::uint32_t> start(static_cast<std::size_t>(side) * side + 1, 0), home(n);
  std::vector<std::uint8_t> is_stale(n, 0);
  for (const std::uint32_t i : stale) is_stale[i] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    home[i] = cell_of(circles_[i].centre.y) * side + cell_of(circles_[i].centre.x);
    ++start[home[i] + 1];
  }
  double crowd = 0;
  for (std::size_t c = 0; c + 1 < start.size(); ++c) {
    crowd += static_cast<double>(start[c + 1]) * start[c + 1];
    start[c + 1] += start[c];
  }
  if (crowd > kUneven * static_cast<double>(n)) return find_uneven(stale, is_stale);
  std::vector<Entry> entries(n);
  {
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i)
      entries[at[home[i]]++] = {circles_[i].centre, circles_[i].radius + slack_of(circles_[i]), i};
  }
  for (const std::uint32_t i : stale) {
    const TorusPoint centre = circles_[i].centre;
    const float reach = circles_[i].radius + slack_of(circles_[i]);
    const auto look = [&](std::uint32_t column, std::uint32_t row) {
      const std::size_t cell = static_cast<std::size_t>(row) * side + column;
      for (std::uint32_t e = start[cell]; e < start[cell + 1]; ++e) {
        const Entry& other = entries[e];
        const auto dx = static_cast<float>(difference(other.centre.x, centre.x));
        const auto dy = static_cast<float>(difference(other.centre.y, centre.y));
        const float sum = reach + other.reach;
        if (dx * dx + dy * dy >= sum * sum) continue;
        // Of two stale ones the larger circle finds the pair: twice its radius is as far as one has to look.
        if ((other.reach > reach || (other.reach == reach && other.index >= i)) && is_stale[other.index])
          continue;
        found.push_back({std::min(i, other.index), std::max(i, other.index)});
      }
    };
    const std::uint32_t x = home[i] % side, y = home[i] / side;
    const double far = (reach + std::max(reach, (kWide + 1) * slack_)) * 0x1p-32 * side + 1;
    if (2 * far + 1 >= side) {  // all around the torus: every cell once
      for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) look(column, row);
      }
      continue;
    }
    const auto rings = static_cast<std::uint32_t>(far);
    for (std::uint32_t v = 0; v <= 2 * rings; ++v) {
      const std::uint32_t row = (y + side - rings + v) % side;
      for (std::uint32_t u = 0, column = (x + side - rings) % side; u <= 2 * rings; ++u) {
        look(column, row);
        if (++column == side) column = 0;
      }
    }
  }
  return found;
}

std::vector<CcvtPairs::Names> CcvtPairs::find_uneven(const std::vector<std::uint32_t>& stale,
                                                     const std::vector<std::uint8_t>& is_stale) const {
  std::vector<float> slacks;
  for (const Circle& circle : circles_) slacks.push_back(slack_of(circle));
  const CcvtCircleTree tree(circles_, slacks, is_stale);
  std::vector<Names> found;
  for (const std::uint32_t i : stale)
    tree.overlaps(i, [&](std::uint32_t j) { found.push_back({std::min(i, j), std::max(i, j)}); });
  return found;
}

void CcvtPairs::share_out(const std::vector<Names>& found) {
  // Sites near each other in the order are near each other in space: blocks of them, and the pairs of blocks.
  struct Group {
    std::uint32_t block, other;
    std::size_t count = 0;
    std::uint32_t phase = 0;
  };
  const std::size_t n = circles_.size();
  std::vector<Group> groups;
  std::vector<std::vector<std::uint32_t>> of_block(n / block_ + 1);  // groups with it as their first
  const std::size_t known = pairs_.size();
  std::vector<std::uint32_t> group_of(known + found.size());
  for (std::size_t p = 0; p < group_of.size(); ++p) {
    const Names names = p < known ? Names{pairs_[p].i, pairs_[p].j} : found[p - known];
    const std::uint32_t block = names.i / block_, other = names.j / block_;
    auto& list = of_block[block];
    auto at =
        std::find_if(list.begin(), list.end(), [&](std::uint32_t g) { return groups[g].other == other; });
    if (at == list.end()) {
      at = list.insert(list.end(), static_cast<std::uint32_t>(groups.size()));
      groups.push_back({block, other});
    }
    group_of[p] = *at;
    ++groups[*at].count;
  }
  // Each group takes the first phase in which neither block is busy.
  std::vector<std::vector<bool>> busy(of_block.size());
  std::uint32_t phases = 0;
  const auto is_busy = [&](std::uint32_t block, std::uint32_t phase) {
    return phase < busy[block].size() && busy[block][phase];
  };
  const auto occupy = [&](std::uint32_t block, std::uint32_t phase) {
    if (phase >= busy[block].size()) busy[block].resize(phase + 1, false);
    busy[block][phase] = true;
  };
  for (const bool inner : {true, false}) {  // all blocks' own pairs share the first phase
    for (Group& group : groups) {
      if ((group.block == group.other) != inner) continue;
      while (is_busy(group.block, group.phase) || is_busy(group.other, group.phase)) ++group.phase;
      occupy(group.block, group.phase);
      occupy(group.other, group.phase);
      phases = std::max(phases, group.phase + 1);
    }
  }
  std::vector<std::uint32_t> order(groups.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return groups[a].phase < groups[b].phase; });
  tasks_.assign(1, 0);
  phases_.assign(phases + 1, 0);
  std::vector<std::size_t> at(groups.size());
  for (const std::uint32_t g : order) {
    at[g] = tasks_.back();
    tasks_.push_back(tasks_.back() + groups[g].count);
    ++phases_[groups[g].phase + 1];
  }
  for (std::uint32_t phase = 0; phase < phases; ++phase) phases_[phase + 1] += phases_[phase];
  std::vector<Pair> sorted(group_of.size());
  for (std::size_t p = 0; p < known; ++p) sorted[at[group_of[p]]++] = pairs_[p];
  for (std::size_t p = known; p < group_of.size(); ++p) {
    Pair& pair = sorted[at[group_of[p]]++];
    pair.i = found[p - known].i;
    pair.j = found[p - known].j;
    pair.front.most_i = pair.front.most_j = kUnknown;
  }
  pairs_.swap(sorted);
  if (keeps_account_) list_by_site();
}

void CcvtPairs::list_by_site() {
  const std::size_t n = circles_.size();
  first_.assign(n + 1, 0);
  for (const Pair& pair : pairs_) ++first_[pair.i + 1], ++first_[pair.j + 1];
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  of_site_.resize(2 * pairs_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t p = 0; p < pairs_.size(); ++p) {
    of_site_[next[pairs_[p].i]++] = p;
    of_site_[next[pairs_[p].j]++] = p;
  }
}

}  // namespace capcon
