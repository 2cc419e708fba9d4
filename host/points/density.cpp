#include "points/density.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"

namespace capcon {

namespace {

/// The place in [0, count) where the sums before, count + 1 of them, reach the part u of the last.
double inverse(const double* before, std::size_t count, double u) {
  const double target = u * before[count];
  // The last interval that begins at or before the target and is not empty.
  auto k = static_cast<std::size_t>(std::upper_bound(before, before + count + 1, target) - before);
  if (k > count)
    k = static_cast<std::size_t>(std::lower_bound(before, before + count + 1, before[count]) - before);
  const double place = (target - before[k - 1]) / (before[k] - before[k - 1]);
  // Below k also where 2^-40 is less than the rounding there: beyond 8192 texels.
  return std::min(static_cast<double>(k - 1) + std::clamp(place, 0.0, 1 - 0x1p-40),
                  std::nextafter(static_cast<double>(k), 0.0));
}

void check(double value, const std::string& place) {
  if (std::isfinite(value) && value >= 0) return;
  throw InputError(fmt::format("the density is {} at {}; it must be finite and not negative",
                               std::isnan(value) ? "not a number" : fmt::format("{}", value), place));
}

}  // namespace

Density::Density(std::size_t width, std::size_t height, std::vector<double> values)
    : width_(width), height_(height), values_(std::move(values)) {
  if (width == 0 || height == 0 || height > kMostTexels / width)
    throw InputError(fmt::format("a density of {} x {} texels; give 1 to 2^26 of them", width, height));
  for (std::size_t i = 0; i < values_.size(); ++i)
    check(values_[i], fmt::format("pixel ({}, {})", i % width, i / width));
  accumulate();
}

Density Density::of(const std::function<double(double, double)>& function, std::size_t side) {
  std::vector<double> values(side * side);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = (static_cast<double>(i % side) + 0.5) / static_cast<double>(side);
    const double y = (static_cast<double>(i / side) + 0.5) / static_cast<double>(side);
    values[i] = function(x, y);
    if (!(std::isfinite(values[i]) && values[i] >= 0)) check(values[i], fmt::format("x = {}, y = {}", x, y));
  }
  return Density(side, side, std::move(values));
}

void Density::accumulate() {
  const double largest = *std::max_element(values_.begin(), values_.end());
  if (!(largest > 0)) throw InputError("the density is 0 everywhere; there is nowhere to put points");
  rows_.assign(height_ + 1, 0);
  columns_.assign((width_ + 1) * height_, 0);
  for (std::size_t row = 0; row < height_; ++row) {
    double* const before = &columns_[row * (width_ + 1)];
    for (std::size_t column = 0; column < width_; ++column) {
      double& value = values_[row * width_ + column];
      value /= largest;
      before[column + 1] = before[column] + value;
    }
    rows_[row + 1] = rows_[row] + before[width_];
  }
}

std::pair<glm::dvec2, glm::dvec2> Density::support() const {
  std::size_t left = width_, right = 0, top = height_, bottom = 0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i] == 0) continue;
    left = std::min(left, i % width_), right = std::max(right, i % width_ + 1);
    top = std::min(top, i / width_), bottom = std::max(bottom, i / width_ + 1);
  }
  const glm::dvec2 size(width_, height_);
  return {glm::dvec2(left, top) / size, glm::dvec2(right, bottom) / size};
}

glm::dvec2 Density::warp(glm::dvec2 u) const {
  const double y = inverse(rows_.data(), height_, u.y);
  const auto row = static_cast<std::size_t>(y);
  const double x = inverse(&columns_[row * (width_ + 1)], width_, u.x);
  return {x / static_cast<double>(width_), y / static_cast<double>(height_)};
}

Density Density::about_disk() const {
  std::vector<double> inside = values_;
  bool any = false;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const auto gap = [](std::size_t k, std::size_t count) {  // from the middle to the texel's nearer side
      const double low = static_cast<double>(k) / static_cast<double>(count) - 0.5;
      const double high = static_cast<double>(k + 1) / static_cast<double>(count) - 0.5;
      return low > 0 ? low : high < 0 ? high : 0;
    };
    if (std::hypot(gap(i % width_, width_), gap(i / width_, height_)) >= 0.5) inside[i] = 0;
    any |= inside[i] > 0;
  }
  if (!any) throw InputError("the density is 0 everywhere in the disk; there is nowhere to put points");
  return Density(width_, height_, std::move(inside));
}

}  // namespace capcon
