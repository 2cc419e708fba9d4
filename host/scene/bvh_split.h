#pragma once

#include <span>

#include "scene/bvh_references.h"

namespace capcon {

/// Equal bins of the centres on one axis.
struct CentreBins {
  float low = 0, scale = 0;  ///< scale 0: all centres lie in one plane
  int count = 1;

  int of(float centre) const { return std::clamp(static_cast<int>((centre - low) * scale), 0, count - 1); }
};

/// A way to divide references in two, with the boxes and counts of both sides.
struct Split {
  int axis = -1;    ///< -1: there is none
  float plane = 0;  ///< of a spatial split: what lies below it goes left
  /// Of an object split: bins of centres before this one go left.
  CentreBins bins;
  int bin = 0;
  FloatBox left, right;
  std::uint32_t left_count = 0, right_count = 0;
  double cost = 1e300;  ///< of both sides, counts weighted by half areas
};

/// The box of all references, and that of their centres.
struct Bounds {
  FloatBox box, centres;
};
Bounds bounds_of(std::span<const Reference> references);

/// The cheapest division by centres over 32 bins an axis (Wald 2007). `centres`: the box of all centres. None
/// when all centres coincide.
Split best_object_split(std::span<const Reference> references, const FloatBox& centres);

/// The cheapest plane at which to cut space and what lies across it (Stich, Friedrich and Dietrich 2009),
/// over 32 bins an axis. `box`: of all references; at most `spare` more references than there were.
Split best_spatial_split(std::span<const Reference> references, const FloatBox& box, std::size_t spare,
                         const Cutter& cutter);

}  // namespace capcon
