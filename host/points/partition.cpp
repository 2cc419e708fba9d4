#include "points/partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"

namespace capcon {
namespace {

constexpr int kMostPasses = 100;
// Nearest neighbours kept a point, times the number of subsets: one of each subset is almost always among
// them.
constexpr std::uint32_t kListed = 8;

double distance(glm::dvec2 a, glm::dvec2 b) {
  return std::hypot(std::remainder(a.x - b.x, 1.0), std::remainder(a.y - b.y, 1.0));
}

class Partition {
 public:
  Partition(const Points& points, const PartitionOptions& options)
      : points_(points),
        subsets_(options.subsets),
        listed_(std::min<std::size_t>(points.size() - 1, std::size_t(kListed) * options.subsets)) {
    list_neighbours();
    deal_labels(options.seed);
  }

  std::vector<std::uint32_t> run() {
    if (subsets_ > 1) {
      look_up_all();
      for (int pass = 0; pass < kMostPasses && trade_all(); ++pass) {
      }
    }
    return std::move(labels_);
  }

 private:
  struct Neighbour {
    std::uint32_t point;
    double distance;
  };

  void list_neighbours() {
    neighbours_.resize(points_.size() * listed_);
    parallel_for(
        points_.size(),
        [&](std::size_t i) {
          std::vector<Neighbour> all;
          all.reserve(points_.size());
          for (std::uint32_t j = 0; j < points_.size(); ++j) {
            if (j != i) all.push_back({j, distance(points_[i], points_[j])});
          }
          const auto nearer = [](const Neighbour& a, const Neighbour& b) {
            return std::pair(a.distance, a.point) < std::pair(b.distance, b.point);
          };
          std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(listed_), all.end(),
                            nearer);
          std::copy_n(all.begin(), listed_, neighbours_.begin() + static_cast<std::ptrdiff_t>(i * listed_));
        },
        16);
  }

  /// Labels 0 1 2 ... k-1 0 1 ... in an order by hash.
  void deal_labels(std::uint64_t seed) {
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(mix64(seed, 0, a), a) < std::pair(mix64(seed, 0, b), b);
    });
    labels_.resize(points_.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      labels_[order[k]] = static_cast<std::uint32_t>(k % subsets_);
  }

  /// The two nearest points of a subset in a point's list.
  struct Nearest {
    double first, second;  ///< beyond the list: the farthest listed distance, a lower bound
    std::uint32_t point;   ///< the first's; the point itself where none is listed
  };

  void look_up(std::uint32_t i, std::uint32_t label) {
    const Neighbour* list = &neighbours_[i * listed_];
    const double last = list[listed_ - 1].distance;
    Nearest& nearest = nearest_[std::size_t(i) * subsets_ + label];
    nearest = {last, last, i};
    for (std::size_t k = 0; k < listed_; ++k) {
      if (labels_[list[k].point] != label) continue;
      if (nearest.point != i) {
        nearest.second = list[k].distance;
        break;
      }
      nearest.first = list[k].distance;
      nearest.point = list[k].point;
    }
  }

  void look_up_all() {
    nearest_.resize(points_.size() * subsets_);
    listed_by_.resize(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      for (std::uint32_t label = 0; label < subsets_; ++label) look_up(i, label);
      for (std::size_t k = 0; k < listed_; ++k) listed_by_[neighbours_[i * listed_ + k].point].push_back(i);
    }
  }

  /// Distance from point i to the nearest point of a subset other than itself and `without`.
  double nearest(std::uint32_t i, std::uint32_t label, std::uint32_t without) const {
    const Nearest& nearest = nearest_[std::size_t(i) * subsets_ + label];
    return nearest.point == without ? nearest.second : nearest.first;
  }

  void trade(std::uint32_t x, std::uint32_t y) {
    std::swap(labels_[x], labels_[y]);
    for (const std::uint32_t moved : {x, y}) {
      for (const std::uint32_t i : listed_by_[moved]) {
        look_up(i, labels_[x]);
        look_up(i, labels_[y]);
      }
    }
  }

  /// Every point trades with the partner that raises the sum most, if any does. Returns whether anything was
  /// traded.
  bool trade_all() {
    bool traded = false;
    for (std::uint32_t x = 0; x < points_.size(); ++x) {
      const std::uint32_t a = labels_[x];
      const double here = nearest(x, a, x);
      double best_gain = 1e-12;
      std::uint32_t best = x;
      for (std::uint32_t y = 0; y < points_.size(); ++y) {
        const std::uint32_t b = labels_[y];
        if (b == a) continue;
        const double gain = nearest(y, a, x) + nearest(x, b, y) - here - nearest(y, b, y);
        if (gain > best_gain) {
          best_gain = gain;
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

  const Points& points_;
  std::uint32_t subsets_;
  std::size_t listed_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::vector<std::uint32_t>> listed_by_;
  std::vector<Nearest> nearest_;  ///< [point * subsets + label]
  std::vector<std::uint32_t> labels_;
};

}  // namespace

std::vector<std::uint32_t> partition(const Points& points, const PartitionOptions& options) {
  if (options.subsets == 0 || options.subsets > points.size()) {
    throw InputError(fmt::format("{} points cannot be cut into {} subsets", points.size(), options.subsets));
  }
  if (points.size() == 1) return {0};
  return Partition(points, options).run();
}

std::vector<Points> split(const Points& points, const std::vector<std::uint32_t>& labels,
                          std::uint32_t subsets) {
  std::vector<Points> sets(subsets);
  for (std::size_t i = 0; i < points.size(); ++i) sets[labels[i]].push_back(points[i]);
  return sets;
}

}  // namespace capcon
