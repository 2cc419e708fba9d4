#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "image/image.h"

namespace capcon {

/// How far `image` is from `reference`, all over pixels and channels (a grey image stands for three equal
/// channels).
struct Comparison {
  double mse = 0;          ///< mean of (a - b)^2
  double mse_clamped = 0;  ///< the same after clamping both to [0, 1]
  double mse_trimmed =
      0;              ///< without the worst 1 % of pixels (a pixel's error is the mean over its channels)
  double relmse = 0;  ///< mean of (a - b)^2 / (b^2 + 0.01), b the reference
  double max_difference = 0;   ///< largest |a - b|
  double mean_difference = 0;  ///< mean of a - b (signed: bias shows here)
  double beyond = 0;           ///< fraction of pixels in which a channel differs by more than `tolerance`
  double tolerance = 1e-4;
  std::size_t non_finite =
      0;  ///< pixels of `image` or `reference` that are not finite; they are left out of the rest
};

/// InputError when the sizes differ.
Comparison compare(const Image& image, const Image& reference, double tolerance = 1e-4);
nlohmann::json to_json(const Comparison& comparison);

}  // namespace capcon
