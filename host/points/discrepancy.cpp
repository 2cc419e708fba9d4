#include "points/discrepancy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace capcon {
namespace {

constexpr std::size_t kStrip = 256;  // right edges a task

Points sorted_by_x(const Points& points) {
  Points sorted = points;
  std::sort(sorted.begin(), sorted.end(),
            [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return sorted;
}

/// The largest excess of closed boxes of this width over the points whose y are given in order. Of equal y
/// the last has them all below, and the others say less than is true.
double closed_excess(const std::vector<double>& ys, double width, double weight) {
  double most = 0;
  for (std::size_t j = 0; j < ys.size(); ++j)
    most = std::max(most, static_cast<double>(static_cast<int>(j + 1)) * weight - width * ys[j]);
  return most;
}

/// Likewise the largest lack of open boxes: they end just below the next point, or at 1.
double open_lack(const std::vector<double>& ys, double width, double weight) {
  double most = width - static_cast<double>(ys.size()) * weight;
  for (std::size_t j = 0; j < ys.size(); ++j)
    most = std::max(most, width * ys[j] - static_cast<double>(static_cast<int>(j)) * weight);
  return most;
}

/// Prefix sums of values at places 0 .. n-1 that change one at a time (Fenwick 1994).
class SumTree {
 public:
  explicit SumTree(std::size_t n) : sums_(n + 1, 0.0) {}
  void add(std::size_t place, double value) {
    for (std::size_t k = place + 1; k < sums_.size(); k += k & -k) sums_[k] += value;
  }
  /// Of the places below `end`.
  double below(std::size_t end) const {
    double sum = 0;
    for (std::size_t k = end; k > 0; k -= k & -k) sum += sums_[k];
    return sum;
  }

 private:
  std::vector<double> sums_;
};

}  // namespace

double star_discrepancy(const Points& points) {
  if (points.empty()) return 0;
  const Points sorted = sorted_by_x(points);
  const std::size_t n = sorted.size();
  const double weight = 1 / static_cast<double>(n);
  std::vector<double> worst((n + kStrip - 1) / kStrip, 0.0);
  parallel_for(worst.size(), [&](std::size_t strip) {
    const std::size_t begin = strip * kStrip, end = std::min(n, begin + kStrip);
    std::vector<double> ys;
    ys.reserve(end);
    for (std::size_t i = 0; i < begin; ++i) ys.push_back(sorted[i].y);
    std::sort(ys.begin(), ys.end());
    for (std::size_t i = begin; i < end; ++i) {
      const double x = sorted[i].x;
      if (i == 0 || sorted[i - 1].x < x) worst[strip] = std::max(worst[strip], open_lack(ys, x, weight));
      ys.insert(std::upper_bound(ys.begin(), ys.end(), sorted[i].y), sorted[i].y);
      if (i + 1 == n || x < sorted[i + 1].x)
        worst[strip] = std::max(worst[strip], closed_excess(ys, x, weight));
    }
    if (end == n) worst[strip] = std::max(worst[strip], open_lack(ys, 1, weight));
  });
  return *std::max_element(worst.begin(), worst.end());
}

double l2_star_discrepancy(const Points& points) {
  if (points.empty()) return 0;
  const Points sorted = sorted_by_x(points);
  const std::size_t n = sorted.size();
  const double weight = 1 / static_cast<double>(n);
  std::vector<std::size_t> by_y(n), rank(n);
  std::iota(by_y.begin(), by_y.end(), std::size_t{0});
  std::sort(by_y.begin(), by_y.end(), [&](std::size_t a, std::size_t b) {
    return sorted[a].y != sorted[b].y ? sorted[a].y < sorted[b].y : a < b;
  });
  for (std::size_t r = 0; r < n; ++r) rank[by_y[r]] = r;
  SumTree count(n), rest(n);  // of the points passed: how many, and sum of 1 - y
  double single = 0, pairs = 0, passed_rest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = sorted[i].x, y = sorted[i].y;
    single += (1 - x * x) * (1 - y * y);
    const double below = count.below(rank[i]) * (1 - y), above = passed_rest - rest.below(rank[i]);
    pairs += (1 - x) * (2 * (below + above) + (1 - y));
    count.add(rank[i], 1);
    rest.add(rank[i], 1 - y);
    passed_rest += 1 - y;
  }
  const double squared = 1.0 / 9 - weight / 2 * single + weight * weight * pairs;
  return std::sqrt(std::max(0.0, squared));
}

}  // namespace capcon
