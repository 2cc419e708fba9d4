#pragma once

#include <cstdint>

#include "image/image.h"

namespace capcon::stability {

/// How far an image is from another, pixel by pixel, relative to the size of what it shows.
struct Deviation {
  std::uint64_t pixels = 0;
  std::uint64_t non_finite = 0;  ///< pixels of `image` with a value that is not finite
  double largest = 0;  ///< over the others: largest difference of a channel / max(|truth|, mean |truth|)
  double median = 0;
  std::uint64_t beyond = 0;  ///< pixels above the tolerance, non-finite ones included
  double bias = 0;           ///< (sum of image - sum of truth) / sum |truth|
};

/// Where both images are black all over, nothing deviates. Images of the same size.
Deviation deviation(const Image& image, const Image& truth, double tolerance);

}  // namespace capcon::stability
