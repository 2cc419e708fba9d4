#pragma once

#include <vector>

namespace capcon {

/// The filters of FLIP, all products (one a sum of two) of one-dimensional ones: taps from -radius to radius.
struct FlipFilters {
  using Taps = std::vector<double>;
  /// One filter of the contrast sensitivity: sum over its parts of part(x) part(y), 1 in all.
  struct Sensitivity {
    std::vector<Taps> parts;
  };

  /// Radii in pixels follow from the pixels in a degree.
  explicit FlipFilters(double pixels_per_degree);

  int blur_radius = 0;     ///< of the contrast sensitivity filters
  int feature_radius = 0;  ///< of the detectors of edges and points
  Sensitivity achromatic, red_green, blue_yellow;
  Taps smooth;  ///< Gaussian of sum 1: across the direction in which a detector looks
  Taps edge;    ///< its first derivative, halves of sum 1 and -1
  Taps point;   ///< its second derivative, positive taps of sum 1, negative of -1
};

}  // namespace capcon
