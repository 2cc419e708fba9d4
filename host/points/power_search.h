#pragma once

#include <span>

#include "points/kd_tree.h"
#include "points/power_cell.h"

namespace capcon {

/// Finds every site that can cut a power cell, however far away: a tree of boxes, each with the largest
/// weight in it. Const and thread-safe after construction.
class PowerSearch {
 public:
  /// Sites in [-0.5, 1.5)^2, one weight each. They must outlive this.
  PowerSearch(std::span<const glm::dvec2> sites, std::span<const double> weights);

  /// Cuts the cell of site i, as it is so far, by all others that reach into it.
  void cut(std::uint32_t i, PowerCell& cell, std::vector<KdTree::Entry>& queue) const;

 private:
  std::span<const glm::dvec2> sites_;
  std::span<const double> weights_;
  KdTree tree_;
  std::vector<double> heaviest_;  ///< of each node of the tree
};

}  // namespace capcon
