#include "points/subset_distances.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "points/checks.h"

namespace capcon {
namespace {

// Nearest neighbours kept a point, times the number of subsets.
constexpr std::uint32_t kListed = 8;

double distance(glm::dvec2 a, glm::dvec2 b) {
  return std::hypot(std::remainder(a.x - b.x, 1.0), std::remainder(a.y - b.y, 1.0));
}

}  // namespace

SubsetDistances::SubsetDistances(const Points& points, std::vector<std::uint32_t> labels,
                                 std::uint32_t subsets)
    : subsets_(subsets),
      listed_(std::min<std::size_t>(points.size() - 1, std::size_t(kListed) * subsets)),
      stride_(points.size() + 17),
      listed_by_(points.size()),
      first_(stride_ * subsets),
      second_(first_.size()),
      nearest_(first_.size()),
      labels_(std::move(labels)) {
  list_neighbours(points);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (std::uint32_t label = 0; label < subsets_; ++label) look_up(i, label);
    for (std::size_t k = 0; k < listed_; ++k) {
      const Neighbour& other = lists_[i * listed_ + k];
      listed_by_[other.point].push_back({i, other.distance});
    }
  }
}

void SubsetDistances::list_neighbours(const Points& points) {
  lists_.resize(points.size() * listed_);
  parallel_for(
      points.size(),
      [&](std::size_t i) {
        std::vector<Neighbour> all;
        all.reserve(points.size());
        for (std::uint32_t j = 0; j < points.size(); ++j) {
          if (j != i) all.push_back({j, distance(points[i], points[j])});
        }
        const auto nearer = [](const Neighbour& a, const Neighbour& b) {
          return std::pair(a.distance, a.point) < std::pair(b.distance, b.point);
        };
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(listed_), all.end(), nearer);
        std::copy_n(all.begin(), listed_, lists_.begin() + static_cast<std::ptrdiff_t>(i * listed_));
      },
      16);
}

SubsetDistances::Two SubsetDistances::nearest_two(std::uint32_t i, std::uint32_t label) const {
  const Neighbour* list = &lists_[i * listed_];
  Two two{last(i), last(i), i};
  for (std::size_t k = 0; k < listed_; ++k) {
    if (labels_[list[k].point] != label) continue;
    if (two.nearest != i) {
      two.second = list[k].distance;
      break;
    }
    two.first = list[k].distance;
    two.nearest = list[k].point;
  }
  return two;
}

void SubsetDistances::look_up(std::uint32_t i, std::uint32_t label) {
  const Two two = nearest_two(i, label);
  const std::size_t here = at(label, i);
  first_[here] = two.first;
  second_[here] = two.second;
  nearest_[here] = two.nearest;
}

void SubsetDistances::check(std::uint32_t label) const {
  for (std::uint32_t i = 0; i < labels_.size(); ++i) {
    const Two two = nearest_two(i, label);
    const std::size_t here = at(label, i);
    require(first_[here] == two.first && second_[here] == two.second && nearest_[here] == two.nearest,
            "partition: a point's nearest of a subset are others");
  }
}

/// Only who had x among the nearest two must look again.
void SubsetDistances::leave(std::uint32_t x, std::uint32_t label) {
  for (const Neighbour& i : listed_by_[x])
    if (i.distance <= second_[at(label, i.point)]) look_up(i.point, label);
}

void SubsetDistances::enter(std::uint32_t x, std::uint32_t label) {
  for (const Neighbour& i : listed_by_[x]) {
    const std::size_t here = at(label, i.point);
    const bool any = nearest_[here] != i.point;
    if (!any || std::pair(i.distance, x) < std::pair(first_[here], nearest_[here])) {
      second_[here] = any ? first_[here] : last(i.point);
      first_[here] = i.distance;
      nearest_[here] = x;
    } else {
      second_[here] = std::min(second_[here], i.distance);
    }
  }
}

void SubsetDistances::trade(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t a = labels_[x], b = labels_[y];
  labels_[x] = labels_[y] = subsets_;  // in none while both leave
  leave(x, a);
  leave(y, b);
  labels_[x] = b;
  labels_[y] = a;
  enter(x, b);
  enter(y, a);
}

}  // namespace capcon
