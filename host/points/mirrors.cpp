#include "points/mirrors.h"

#include <algorithm>
#include <cmath>

namespace capcon {

namespace {

/// The signs of the k-th image.
glm::dvec2 signs(std::size_t k) {
  return {k & 1 ? -1 : 1, k & 2 ? -1 : 1};
}

}  // namespace

Points mirrored(const Points& points) {
  // A point on a side would meet its image.
  const double least = 1e-3 / std::sqrt(static_cast<double>(std::max<std::size_t>(1, points.size())));
  Points result;
  result.reserve(4 * points.size());
  for (std::size_t k = 0; k < 4; ++k) {
    for (const glm::dvec2& p : points) {
      const glm::dvec2 half(0.5 * std::clamp(p.x, least, 1 - least), 0.5 * std::clamp(p.y, least, 1 - least));
      result.emplace_back(k & 1 ? 1 - half.x : half.x, k & 2 ? 1 - half.y : half.y);
    }
  }
  return result;
}

Points unmirrored(const Points& points) {
  Points result(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 4));
  constexpr double kBelowOne = 1 - 0x1p-53;
  for (glm::dvec2& p : result) {
    p = {std::min(2 * std::min(p.x, 1 - p.x), kBelowOne), std::min(2 * std::min(p.y, 1 - p.y), kBelowOne)};
  }
  return result;
}

void make_alike(std::vector<double>& values) {
  const std::size_t n = values.size() / 4;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += values[i + k * n];
    for (std::size_t k = 0; k < 4; ++k) values[i + k * n] = sum / 4;
  }
}

void make_alike(std::vector<glm::dvec2>& vectors) {
  const std::size_t n = vectors.size() / 4;
  for (std::size_t i = 0; i < n; ++i) {
    glm::dvec2 sum(0);
    for (std::size_t k = 0; k < 4; ++k) sum += signs(k) * vectors[i + k * n];
    for (std::size_t k = 0; k < 4; ++k) vectors[i + k * n] = 0.25 * signs(k) * sum;
  }
}

}  // namespace capcon
