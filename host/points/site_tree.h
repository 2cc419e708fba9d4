#pragma once

#include <cstdint>
#include <vector>

#include "points/kd_tree.h"
#include "points/point_set.h"

namespace capcon {

/// Finds the nearest of many sites, in the plane or on the unit torus; sites can be closed, one by one.
class SiteTree {
 public:
  SiteTree(const Points& sites, bool torus);

  /// The nearest open site; there must be one.
  std::uint32_t nearest(glm::dvec2 p) const;
  void close(std::uint32_t i);
  /// Squared distance, by nearest images on the torus.
  double distance2(glm::dvec2 p, std::uint32_t i) const;

 private:
  struct Best {
    double distance2;
    std::uint32_t site;
  };
  void look(glm::dvec2 p, std::uint32_t node, Best& best) const;

  Points sites_;
  bool torus_;
  KdTree tree_;
  std::vector<std::uint32_t> open_;    ///< open sites below a node
  std::vector<std::uint32_t> parent_;  ///< of a node; the root's is itself
  std::vector<std::uint32_t> leaf_;    ///< of a site
  std::vector<bool> closed_;
};

}  // namespace capcon
