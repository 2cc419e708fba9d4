#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace capcon {
namespace {

bool finite_pixel(const Image& image, std::size_t pixel) {
  const float* p = &image.pixels[pixel * image.channels];
  return std::all_of(p, p + image.channels, [](float v) { return std::isfinite(v); });
}

/// Channel `c` of a pixel; the one channel of a grey image is all of them.
double value(const Image& image, std::size_t pixel, int c) {
  return image.pixels[pixel * image.channels + (image.channels == 1 ? 0 : c)];
}

double square(double x) {
  return x * x;
}

/// The mean without the worst hundredth (rounded down) of the values.
double trimmed_mean(std::vector<double>& errors) {
  const auto kept = static_cast<std::ptrdiff_t>(errors.size() - errors.size() / 100);
  if (kept < std::ssize(errors)) std::nth_element(errors.begin(), errors.begin() + kept, errors.end());
  double sum = 0;
  for (std::ptrdiff_t i = 0; i < kept; ++i) sum += errors[i];
  return sum / static_cast<double>(kept);
}

}  // namespace

Comparison compare(const Image& image, const Image& reference, double tolerance) {
  if (image.width != reference.width || image.height != reference.height) {
    throw InputError(
        fmt::format("the images differ in size: {} x {} against {} x {}; compare renders of one resolution",
                    image.width, image.height, reference.width, reference.height));
  }
  if (image.channels != reference.channels && image.channels != 1 && reference.channels != 1) {
    throw InputError(
        fmt::format("the images have {} and {} channels; one of them must be grey, or both have as many",
                    image.channels, reference.channels));
  }
  const int channels = std::max(image.channels, reference.channels);
  Comparison result;
  result.tolerance = tolerance;
  std::vector<double> errors;  // one a finite pixel
  errors.reserve(std::size_t(image.width) * image.height);
  std::size_t beyond = 0;
  for (std::size_t pixel = 0; pixel < std::size_t(image.width) * image.height; ++pixel) {
    if (!finite_pixel(image, pixel) || !finite_pixel(reference, pixel)) {
      ++result.non_finite;
      continue;
    }
    double error = 0;
    double worst = 0;
    for (int c = 0; c < channels; ++c) {
      const double a = value(image, pixel, c);
      const double b = value(reference, pixel, c);
      error += square(a - b);
      worst = std::max(worst, std::abs(a - b));
      result.mse_clamped += square(std::clamp(a, 0.0, 1.0) - std::clamp(b, 0.0, 1.0));
      result.relmse += square(a - b) / (square(b) + 0.01);
      result.mean_difference += a - b;
    }
    result.mse += error;
    result.max_difference = std::max(result.max_difference, worst);
    if (worst > tolerance) ++beyond;
    errors.push_back(error / channels);
  }
  if (errors.empty()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, kUnknown,  kUnknown,         kUnknown,
            kUnknown, kUnknown, tolerance, result.non_finite};
  }
  const double values = static_cast<double>(errors.size()) * channels;
  result.mse /= values;
  result.mse_clamped /= values;
  result.relmse /= values;
  result.mean_difference /= values;
  result.beyond = static_cast<double>(beyond) / static_cast<double>(errors.size());
  result.mse_trimmed = trimmed_mean(errors);
  return result;
}

nlohmann::json to_json(const Comparison& c) {
  return {{"mse", c.mse},       {"mse_clamped", c.mse_clamped},       {"mse_trimmed", c.mse_trimmed},
          {"relmse", c.relmse}, {"max_difference", c.max_difference}, {"mean_difference", c.mean_difference},
          {"beyond", c.beyond}, {"tolerance", c.tolerance},           {"non_finite", c.non_finite}};
}

}  // namespace capcon
