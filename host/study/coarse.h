#pragma once

#include "image/image.h"

namespace capcon {

/// Side of the blocks, in pixels, whose means show coarse error: blotches that the eye sees, where noise of
/// single pixels has averaged out.
inline constexpr int kCoarseBlock = 8;

/// The means of blocks of kCoarseBlock x kCoarseBlock pixels; those at the right and at the bottom hold what
/// is left.
Image block_means(const Image& image);

/// Mean square of a grid of block means of a `width` x `height` image, blocks weighted by their pixels.
double coarse_mean_square(const Image& blocks, int width, int height);

/// The part of the MSE that is left in block means: mean over all pixels and channels of the squared
/// difference of their blocks' means. Independent errors leave one in 64 of their MSE, a constant error all
/// of it.
double coarse_mse(const Image& image, const Image& reference);

}  // namespace capcon
