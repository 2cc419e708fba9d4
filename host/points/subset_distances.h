#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "points/point_set.h"

namespace capcon {

/// Distances on the unit torus from every point to the nearest two of every subset, kept while points go from
/// one subset to another. Each point has a list of its 8 k nearest, k subsets: one of each subset is almost
/// always among them.
class SubsetDistances {
 public:
  /// `labels`: the subset of each point, below `subsets`. At least two points. O(n^2), on all threads.
  SubsetDistances(const Points& points, std::vector<std::uint32_t> labels, std::uint32_t subsets);

  /// Another point and how far it is.
  struct Neighbour {
    std::uint32_t point;
    double distance;
  };

  /// To the nearest point of a subset other than i itself; without one in the list, the farthest listed
  /// distance, a lower bound.
  double first(std::uint32_t i, std::uint32_t label) const { return first_[at(label, i)]; }
  /// The point which that is, i itself without one.
  std::uint32_t nearest(std::uint32_t i, std::uint32_t label) const { return nearest_[at(label, i)]; }
  /// To the nearest point of a subset other than i and `without`.
  double first_without(std::uint32_t i, std::uint32_t label, std::uint32_t without) const {
    const std::size_t here = at(label, i);
    return nearest_[here] == without ? second_[here] : first_[here];
  }
  /// Who has point x in its list.
  const std::vector<Neighbour>& listed_by(std::uint32_t x) const { return listed_by_[x]; }
  const std::vector<std::uint32_t>& labels() const { return labels_; }

  /// Points x and y exchange their subsets.
  void trade(std::uint32_t x, std::uint32_t y);

  /// Throws BrokenInvariant unless all distances to a subset are what a look at the lists says.
  void check(std::uint32_t label) const;

 private:
  void list_neighbours(const Points& points);
  /// The nearest two of a subset to point i.
  struct Two {
    double first, second;
    std::uint32_t nearest;
  };
  Two nearest_two(std::uint32_t i, std::uint32_t label) const;
  void look_up(std::uint32_t i, std::uint32_t label);
  void leave(std::uint32_t x, std::uint32_t label);
  void enter(std::uint32_t x, std::uint32_t label);
  std::size_t at(std::uint32_t label, std::uint32_t i) const { return label * stride_ + i; }
  double last(std::uint32_t i) const { return lists_[(i + std::size_t(1)) * listed_ - 1].distance; }

  std::uint32_t subsets_;
  std::size_t listed_;
  // Not n: where that is a power of two, all subsets' distances of a point would share a cache set.
  std::size_t stride_;
  std::vector<Neighbour> lists_;  ///< [point * listed_ + k], the nearest first
  std::vector<std::vector<Neighbour>> listed_by_;
  std::vector<double> first_, second_;  ///< [label * stride_ + point]
  std::vector<std::uint32_t> nearest_;
  std::vector<std::uint32_t> labels_;
};

}  // namespace capcon
