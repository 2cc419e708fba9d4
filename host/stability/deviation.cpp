#include "stability/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"

namespace capcon::stability {

Deviation deviation(const Image& image, const Image& truth, double tolerance) {
  if (image.pixels.size() != truth.pixels.size()) throw Failure("images of different sizes were compared");
  Deviation result;
  const std::size_t channels = image.channels;
  result.pixels = image.pixels.size() / channels;
  double sum = 0;
  for (const float v : truth.pixels) sum += std::abs(static_cast<double>(v));
  const double mean = sum / static_cast<double>(truth.pixels.size());
  std::vector<double> all;
  double difference = 0;
  for (std::size_t p = 0; p < result.pixels; ++p) {
    double worst = 0;
    bool finite = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const double a = image.pixels[p * channels + c], b = truth.pixels[p * channels + c];
      const double off = std::abs(a - b);
      const double size = std::max(std::abs(b), mean);
      finite = finite && std::isfinite(a);
      worst =
          std::max(worst, off == 0 ? 0 : off / size);  // infinite where something is seen of a black scene
      if (std::isfinite(a)) difference += a - b;
    }
    if (!finite) {
      ++result.non_finite;
      ++result.beyond;
      continue;
    }
    all.push_back(worst);
    if (worst > tolerance) ++result.beyond;
  }
  result.bias = difference == 0 ? 0 : difference / sum;
  if (all.empty()) return result;
  std::sort(all.begin(), all.end());
  result.largest = all.back();
  result.median = all[all.size() / 2];
  return result;
}

}  // namespace capcon::stability
