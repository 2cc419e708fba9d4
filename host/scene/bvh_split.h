#pragma once

#include <span>

#include "scene/bvh_references.h"

namespace capcon {

/// A way to divide references in two, with the boxes and counts of both sides.
struct Split {
  int axis = -1;    ///< -1: there is none
  float plane = 0;  ///< centres (object split) or space (spatial split) below it go left
  FloatBox left, right;
  std::uint32_t left_count = 0, right_count = 0;
  double cost = 1e300;  ///< of both sides, counts weighted by half areas
};

/// The cheapest division by centres over 32 bins an axis (Wald 2007). `centres`: the box of all centres. None
/// when all centres coincide.
Split best_object_split(std::span<const Reference> references, const FloatBox& centres);

/// The cheapest plane at which to cut space and what lies across it (Stich, Friedrich and Dietrich 2009),
/// over 32 bins an axis. `box`: of all references; at most `spare` more references than there were.
Split best_spatial_split(std::span<const Reference> references, const FloatBox& box, std::size_t spare,
                         const Cutter& cutter);

}  // namespace capcon
