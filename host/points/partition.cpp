#include "points/partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "points/checks.h"
#include "points/subset_distances.h"

namespace capcon {
namespace {

// A trade raises the sum over its two points by more than rounding, and yet others may lose, so that labels
// could come again: it is this that ends the passes.
constexpr int kMostPasses = 100;

/// Labels 0 1 2 ... k-1 0 1 ... in an order by hash.
std::vector<std::uint32_t> dealt_labels(std::size_t points, const PartitionOptions& options) {
  std::vector<std::uint32_t> order(points), labels(points);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(mix64(options.seed, 0, a), a) < std::pair(mix64(options.seed, 0, b), b);
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    labels[order[k]] = static_cast<std::uint32_t>(k % options.subsets);
  return labels;
}

class Partition {
 public:
  Partition(const Points& points, const PartitionOptions& options)
      : n_(static_cast<std::uint32_t>(points.size())),
        subsets_(options.subsets),
        distances_(points, dealt_labels(points.size(), options), options.subsets),
        own_(n_),
        members_(subsets_),
        most_(std::size_t(subsets_) * subsets_),
        known_(most_.size()) {
    for (std::uint32_t i = 0; i < n_; ++i) {
      own_[i] = distances_.first(i, label(i));
      members_[label(i)].push_back(i);
    }
  }

  std::vector<std::uint32_t> run() {
    for (int pass = 0; pass < kMostPasses && trade_all(); ++pass) {
    }
    if constexpr (kChecks) check_sizes();
    return distances_.labels();
  }

 private:
  std::uint32_t label(std::uint32_t i) const { return distances_.labels()[i]; }

  /// Of the sum over both points.
  double gain(std::uint32_t x, std::uint32_t y) const {
    return distances_.first_without(y, label(x), x) + distances_.first_without(x, label(y), y) - own_[x] -
           own_[y];
  }

  void trade(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t a = label(x), b = label(y);
    [[maybe_unused]] double expected = 0;
    if constexpr (kChecks) expected = gain(x, y);
    distances_.trade(x, y);
    if constexpr (kChecks) {
      distances_.check(a);
      distances_.check(b);
      const double rise = distances_.first(x, b) + distances_.first(y, a) - own_[x] - own_[y];
      require(std::abs(rise - expected) <= 1e-15, "partition: a trade did not gain what it was made for");
      check_step(Checked::kPartition, -rise, 0, 2);
    }
    std::replace(members_[a].begin(), members_[a].end(), x, y);
    std::replace(members_[b].begin(), members_[b].end(), y, x);
    for (const std::uint32_t changed : {a, b}) {
      for (const std::uint32_t i : members_[changed]) own_[i] = distances_.first(i, changed);
      for (std::uint32_t other = 0; other < subsets_; ++other)
        known_[changed * subsets_ + other] = known_[other * subsets_ + changed] = 0;
    }
  }

  /// The most that a point of subset b gains itself by going to subset a.
  double most_to_gain(std::uint32_t a, std::uint32_t b) {
    const std::size_t pair = std::size_t(a) * subsets_ + b;
    if (known_[pair] == 0) {
      double most = -std::numeric_limits<double>::infinity();
      for (const std::uint32_t y : members_[b]) most = std::max(most, distances_.first(y, a) - own_[y]);
      most_[pair] = most;
      known_[pair] = 1;
    }
    return most_[pair];
  }

  /// Whether certainly no trade of point x gains: so it is for most points in most passes, and this tells
  /// without a look at all others. A pair gains what each gains alone, but for a point whose nearest in the
  /// other's subset is the other.
  bool gains_nothing(std::uint32_t x) {
    constexpr double kLeast = -1e-9;  // rounding lies between
    const std::uint32_t a = label(x);
    for (std::uint32_t b = 0; b < subsets_; ++b) {
      if (b == a) continue;
      if (most_to_gain(a, b) + distances_.first(x, b) - own_[x] > kLeast) return false;
      const std::uint32_t nearest = distances_.nearest(x, b);
      if (nearest != x && gain(x, nearest) > kLeast) return false;
    }
    for (const auto& [y, distance] : distances_.listed_by(x)) {
      if (label(y) != a && distances_.nearest(y, a) == x && gain(x, y) > kLeast) return false;
    }
    return true;
  }

  /// Every point trades with the partner that raises the sum most, if any does. Returns whether anything was
  /// traded.
  bool trade_all() {
    bool traded = false;
    for (std::uint32_t x = 0; x < n_; ++x) {
      if (gains_nothing(x)) continue;
      double best_gain = 1e-12;
      std::uint32_t best = x;
      for (std::uint32_t y = 0; y < n_; ++y) {
        if (label(y) == label(x)) continue;
        if (const double g = gain(x, y); g > best_gain) {
          best_gain = g;
          best = y;
        }
      }
      if (best != x) {
        trade(x, best);
        traded = true;
      }
    }
    return traded;
  }

  void check_sizes() const {
    std::vector<std::size_t> sizes(subsets_);
    for (std::uint32_t i = 0; i < n_; ++i) ++sizes.at(label(i));
    for (std::uint32_t s = 0; s < subsets_; ++s) {
      require(sizes[s] == members_[s].size(), "partition: a subset has not its members");
      require(sizes[s] == n_ / subsets_ + (s < n_ % subsets_ ? 1 : 0), "partition: subsets of uneven sizes");
    }
  }

  std::uint32_t n_, subsets_;
  SubsetDistances distances_;
  std::vector<double> own_;  ///< [point]: to the nearest of its own subset
  std::vector<std::vector<std::uint32_t>> members_;
  std::vector<double> most_;  ///< [a * subsets + b]: most_to_gain, where known_
  std::vector<char> known_;
};

}  // namespace

std::vector<std::uint32_t> partition(const Points& points, const PartitionOptions& options) {
  if (options.subsets == 0 || options.subsets > points.size()) {
    throw InputError(fmt::format("{} points cannot be cut into {} subsets", points.size(), options.subsets));
  }
  if (points.size() == 1 || options.subsets == 1) return std::vector<std::uint32_t>(points.size());
  return Partition(points, options).run();
}

std::vector<Points> split(const Points& points, const std::vector<std::uint32_t>& labels,
                          std::uint32_t subsets) {
  std::vector<Points> sets(subsets);
  for (std::size_t i = 0; i < points.size(); ++i) sets[labels[i]].push_back(points[i]);
  return sets;
}

}  // namespace capcon
