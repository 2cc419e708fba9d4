#include "shading/texture.h"

#include <cmath>
#include <glm/common.hpp>

namespace capcon {
namespace {

/// The sRGB curve (IEC 61966-2-1), linear to encoded.
double encoded(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

/// Coordinate of a texel after wrapping, -1 where it is black.
std::int64_t wrapped(double coordinate, std::int64_t size, Wrap wrap) {
  const double extent = static_cast<double>(size);
  if (wrap == Wrap::clamp) return static_cast<std::int64_t>(std::min(std::max(coordinate, 0.0), extent - 1));
  if (wrap == Wrap::black && !(coordinate >= 0 && coordinate < extent)) return -1;
  return static_cast<std::int64_t>(coordinate - std::floor(coordinate / extent) * extent) % size;
}

}  // namespace

glm::dvec3 texel(const Texture& texture, const Image& image, int x, int y) {
  glm::dvec3 colour;
  for (int c = 0; c < 3; ++c) {
    double value = image.at(x, y, image.channels == 1 ? 0 : c);
    if (texture.encode) value = encoded(value);
    colour[c] = texture.invert ? 1 - value : value;
  }
  return colour;
}

glm::dvec3 lookup(const Texture& texture, const std::vector<SceneImage>& images, const glm::dvec2& uv) {
  if (texture.image < 0) return texture.average;
  const Image& image = images[texture.image].image;
  const double x = (texture.scale.x * uv.x + texture.offset.x) * image.width - 0.5;
  const double y = (1 - (texture.scale.y * uv.y + texture.offset.y)) * image.height - 0.5;
  if (!std::isfinite(x) || !std::isfinite(y)) return texture.average;
  const double left = std::floor(x), top = std::floor(y);
  glm::dvec3 sum(0);
  for (const int corner : {0, 1, 2, 3}) {
    const int right = corner & 1, below = corner >> 1;
    const std::int64_t column = wrapped(left + right, image.width, texture.wrap);
    const std::int64_t row = wrapped(top + below, image.height, texture.wrap);
    if (column < 0 || row < 0) continue;
    const double weight = (right ? x - left : 1 - (x - left)) * (below ? y - top : 1 - (y - top));
    sum += weight * texel(texture, image, static_cast<int>(column), static_cast<int>(row));
  }
  return texture.factor * sum;
}

}  // namespace capcon
