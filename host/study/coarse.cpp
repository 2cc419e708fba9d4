#include "study/coarse.h"

#include <algorithm>
#include <cassert>

namespace capcon {
namespace {

int blocks_in(int pixels) {
  return (pixels + kCoarseBlock - 1) / kCoarseBlock;
}

/// Pixels of block number `block` along a side.
int extent(int block, int pixels) {
  return std::min(kCoarseBlock, pixels - block * kCoarseBlock);
}

}  // namespace

Image block_means(const Image& image) {
  const int width = blocks_in(image.width), height = blocks_in(image.height), channels = image.channels;
  std::vector<double> sums(static_cast<std::size_t>(width) * height * channels);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t block = static_cast<std::size_t>(y / kCoarseBlock) * width + x / kCoarseBlock;
      for (int c = 0; c < channels; ++c) sums[block * channels + c] += image.at(x, y, c);
    }
  }
  Image result(width, height, channels);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double pixels = extent(x, image.width) * extent(y, image.height);
      for (int c = 0; c < channels; ++c) {
        const double sum = sums[(static_cast<std::size_t>(y) * width + x) * channels + c];
        result.at(x, y, c) = static_cast<float>(sum / pixels);
      }
    }
  }
  return result;
}

double coarse_mean_square(const Image& blocks, int width, int height) {
  assert(blocks.width == blocks_in(width) && blocks.height == blocks_in(height));
  double sum = 0;
  for (int y = 0; y < blocks.height; ++y) {
    for (int x = 0; x < blocks.width; ++x) {
      const double pixels = extent(x, width) * extent(y, height);
      for (int c = 0; c < blocks.channels; ++c) {
        const double v = blocks.at(x, y, c);
        sum += pixels * v * v;
      }
    }
  }
  return sum / width / height / blocks.channels;
}

double coarse_mse(const Image& image, const Image& reference) {
  Image difference = image;
  for (std::size_t i = 0; i < difference.pixels.size(); ++i) difference.pixels[i] -= reference.pixels[i];
  return coarse_mean_square(block_means(difference), image.width, image.height);
}

}  // namespace capcon
