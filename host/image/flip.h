#pragma once

#include <numbers>

#include "image/image.h"

namespace capcon {

/// Pixels in a degree of the viewer's eye: a display of 3840 pixels on 0.7 m, seen from 0.7 m (67.0).
inline constexpr double kFlipPixelsPerDegree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

/// How different two images look when one flips between them, pixel by pixel in [0, 1]: LDR-FLIP of Andersson
/// et al., "FLIP: A Difference Evaluator for Alternating Images" (2020), of linear values clamped to [0, 1],
/// as their sRGB previews at exposure 1 show them. Symmetric; 0 where they look the same. Pixels that are not
/// finite in one of them count as black in both. InputError when the sizes differ.
Image flip_map(const Image& image, const Image& reference, double pixels_per_degree = kFlipPixelsPerDegree);

/// The mean of flip_map().
double flip(const Image& image, const Image& reference, double pixels_per_degree = kFlipPixelsPerDegree);

/// FLIP of images of any range.
struct HdrFlip {
  double value = 0;        ///< mean over pixels of the largest FLIP of all exposures
  double start = 0;        ///< first exposure, in powers of two
  double stop = 0;         ///< last exposure
  unsigned exposures = 0;  ///< evenly from start to stop, a power of two or less apart; at least 2
};

/// HDR-FLIP of Andersson et al., "Visualizing Errors in Rendered High Dynamic Range Images" (2021): the
/// exposures are those that show the brightest and the median pixel of the reference at 0.85 by the ACES
/// curve (in the fit of Narkowicz, with its 0.6), which also maps the images. Of a black reference: exposure
/// 0 alone.
HdrFlip hdr_flip(const Image& image, const Image& reference, double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace capcon
