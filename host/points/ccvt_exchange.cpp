#include "points/ccvt_exchange.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "points/ccvt_checks.h"
#include "points/ccvt_keys.h"
#include "points/checks.h"

namespace capcon {

namespace {

/// The slots whose key is above the limit, largest key first.
std::uint32_t collect(const CcvtKernels& kernels, const std::vector<float>& keys, std::uint32_t count,
                      float limit, std::vector<CcvtCandidate>& into) {
  if (into.size() < count) into.resize(count);
  const std::uint32_t found = kernels.select(keys.data(), count, limit, into.data());
  std::sort(into.begin(), into.begin() + found, [](const CcvtCandidate& a, const CcvtCandidate& b) {
    return a.key != b.key ? a.key > b.key : a.slot < b.slot;
  });
  return found;
}

/// One point into a slot of site s in place of another.
struct Replacement {
  CcvtCells& cells;
  std::size_t s;
  CcvtSite& site = cells.sites[s];
  bool unsorted = false;  ///< an inner slot got a point that is too far out
  bool refitted = false;
  float reach2 = site.reach * site.reach;

  void put(std::uint32_t slot, TorusPoint old, TorusPoint fresh) {
    cells.x(s)[slot] = fresh.x;
    cells.y(s)[slot] = fresh.y;
    const std::int32_t dx = difference(fresh.x, site.centre.x), dy = difference(fresh.y, site.centre.y);
    site.sum_x += dx - static_cast<std::int64_t>(difference(old.x, site.centre.x));
    site.sum_y += dy - static_cast<std::int64_t>(difference(old.y, site.centre.y));
    const float distance2 =
        static_cast<float>(dx) * static_cast<float>(dx) + static_cast<float>(dy) * static_cast<float>(dy);
    reach2 = std::max(reach2, distance2 * 1.000002f);
    unsorted |= slot >= site.outer && distance2 > site.inner * site.inner;
  }
  void finish() {
    site.reach = std::sqrt(reach2);
    const double x = site.x, y = site.y;
    cells.place(s);
    site.travel += 1 + std::sqrt((site.x - x) * (site.x - x) + (site.y - y) * (site.y - y));
    const double drift = 0.1 * site.inner;
    refitted = unsorted || cells.is_large(s) || site.x * site.x + site.y * site.y > drift * drift;
    if (refitted) cells.refit(s);
  }
};

/// Trades the foremost candidates of both sides while their keys add up to more than the limit.
std::uint32_t trade(CcvtCells& cells, std::size_t i, std::size_t j, float limit, CcvtScratch& scratch) {
  Replacement to_i{cells, i}, to_j{cells, j};
  const std::uint32_t most = std::min(scratch.count_i, scratch.count_j);
  std::uint32_t count = 0;
  for (; count < most && scratch.from_i[count].key + scratch.from_j[count].key > limit; ++count) {
    const std::uint32_t a = scratch.from_i[count].slot, b = scratch.from_j[count].slot;
    const TorusPoint p{cells.x(i)[a], cells.y(i)[a]}, q{cells.x(j)[b], cells.y(j)[b]};
    to_i.put(a, p, q);
    to_j.put(b, q, p);
  }
  if (count > 0) {
    to_i.finish();
    to_j.finish();
    scratch.refitted_i = to_i.refitted;
    scratch.refitted_j = to_j.refitted;
    // What is left: the next candidate or, when there is none, a key that was too low to be one; and what
    // came over, whose keys on the other side are mirrored about `apart`.
    CcvtFront& front = scratch.front;
    const float last_i = scratch.from_i[count - 1].key, last_j = scratch.from_j[count - 1].key;
    const float rest_i = count < scratch.count_i ? scratch.from_i[count].key : limit - front.most_j;
    const float rest_j = count < scratch.count_j ? scratch.from_j[count].key : limit - front.most_i;
    front.most_i = std::max(rest_i, limit - last_j);
    front.most_j = std::max(rest_j, limit - last_i);
  }
  return count;
}

/// keys[k] = |p - s|^2 - |p - t|^2 by nearest images; returns the largest. Differences of whole units wrap
/// around by themselves, so sites are rounded to such: 2^-32 of the torus.
float compare_images(const CcvtCells& cells, std::size_t s, std::size_t t, std::vector<float>& keys) {
  const auto place = [&](const CcvtSite& site) {
    return TorusPoint{site.centre.x + static_cast<std::uint32_t>(std::llround(site.x)),
                      site.centre.y + static_cast<std::uint32_t>(std::llround(site.y))};
  };
  const TorusPoint own = place(cells.sites[s]), other = place(cells.sites[t]);
  const std::uint32_t* const x = cells.x(s);
  const std::uint32_t* const y = cells.y(s);
  float largest = -std::numeric_limits<float>::infinity();
  for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
    const double own_x = difference(x[k], own.x), own_y = difference(y[k], own.y);
    const double other_x = difference(x[k], other.x), other_y = difference(y[k], other.y);
    keys[k] = static_cast<float>(own_x * own_x + own_y * own_y - (other_x * other_x + other_y * other_y));
  }
  for (std::uint32_t k = 0; k < cells.capacity(); ++k) largest = keys[k] > largest ? keys[k] : largest;
  return largest;
}

std::uint32_t exchange_best(CcvtCells& cells, std::size_t i, std::size_t j, CcvtScratch& scratch) {
  static const CcvtKernels kernels = best_ccvt_kernels();
  const std::uint32_t capacity = cells.capacity();
  const CcvtSite& a = cells.sites[i];
  const CcvtSite& b = cells.sites[j];
  scratch.keys_i.resize(capacity);
  scratch.keys_j.resize(capacity);
  constexpr float kUnknown = std::numeric_limits<float>::infinity();
  scratch.front = {0, 0, kUnknown, kUnknown, 0};

  if (cells.is_large(i) || cells.is_large(j)) {  // the nearest images of a point may differ for the two sites
    const float most_i = compare_images(cells, i, j, scratch.keys_i);
    const float most_j = compare_images(cells, j, i, scratch.keys_j);
    const float epsilon = 0x1p-20f * 0x1p62f;  // keys are at most 2^63, rounded at 2^-24 of that
    if (most_i + most_j <= epsilon) {
      scratch.front = {0, 0, 0, 0, 0};  // settled until a site moves
      return 0;
    }
    scratch.count_i = collect(kernels, scratch.keys_i, capacity, epsilon - most_j, scratch.from_i);
    scratch.count_j = collect(kernels, scratch.keys_j, capacity, epsilon - most_i, scratch.from_j);
    return trade(cells, i, j, epsilon, scratch);
  }

  const double centres_x = difference(b.centre.x, a.centre.x), centres_y = difference(b.centre.y, a.centre.y);
  const double dx = centres_x + b.x - a.x, dy = centres_y + b.y - a.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return 0;
  const auto ux = static_cast<float>(dx / length), uy = static_cast<float>(dy / length);
  // With keys u . (p - c_i) for p of i and -u . (q - c_j) for q of j, trading p and q gains when their sum is
  // above the distance of the centres along u. Keys and the unit vector are rounded at 2^-24, hence 2^-20: a
  // trade is made only where the energy truly falls, so the same assignment never comes back, and there are
  // finitely many.
  const auto apart = static_cast<float>(centres_x * ux + centres_y * uy);
  const float limit = apart + 0x1p-20f * (a.reach + b.reach + std::abs(apart));
  scratch.front = {ux, uy, a.reach, b.reach, limit};
  if (a.reach + b.reach <= limit) return 0;
  constexpr float kNone = -std::numeric_limits<float>::infinity();
  std::uint32_t count_i = a.outer, count_j = b.outer;
  float most_i =
      kernels.project(cells.x(i), cells.y(i), 0, count_i, a.centre, ux, uy, scratch.keys_i.data(), kNone);
  float most_j =
      kernels.project(cells.x(j), cells.y(j), 0, count_j, b.centre, -ux, -uy, scratch.keys_j.data(), kNone);
  // Inner points cannot have larger keys than the inner radius: mostly that leaves them out.
  if (a.inner > limit - std::max(most_j, b.inner) || b.inner > limit - std::max(most_i, a.inner)) {
    most_i = kernels.project(cells.x(i), cells.y(i), count_i, capacity, a.centre, ux, uy,
                             scratch.keys_i.data(), most_i);
    most_j = kernels.project(cells.x(j), cells.y(j), count_j, capacity, b.centre, -ux, -uy,
                             scratch.keys_j.data(), most_j);
    count_i = count_j = capacity;
  }
  scratch.front.most_i = count_i < capacity ? std::max(most_i, a.inner) : most_i;
  scratch.front.most_j = count_j < capacity ? std::max(most_j, b.inner) : most_j;
  if (most_i + most_j <= limit) return 0;
  scratch.count_i = collect(kernels, scratch.keys_i, count_i, limit - most_j, scratch.from_i);
  scratch.count_j = collect(kernels, scratch.keys_j, count_j, limit - most_i, scratch.from_j);
  return trade(cells, i, j, limit, scratch);
}

}  // namespace

std::uint32_t exchange(CcvtCells& cells, std::size_t i, std::size_t j, CcvtScratch& scratch) {
  if constexpr (kChecks) {
    const ExchangeCheck check(cells, i, j);
    const std::uint32_t count = exchange_best(cells, i, j, scratch);
    check.end(count);
    return count;
  }
  return exchange_best(cells, i, j, scratch);
}

}  // namespace capcon
