#include "shading/sphere_map.h"

#include <algorithm>
#include <cmath>

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dvec2 octahedral_square(const glm::dvec3& d) {
  const double r = std::sqrt(std::max(0.0, 1 - std::abs(d.z)));
  const double turn = std::atan2(std::abs(d.y), std::abs(d.x)) / (kPi / 2);  // 0 to 1 in a quadrant
  double v = turn * r, u = r - v;
  if (d.z < 0) {
    std::swap(u, v);
    u = 1 - u;
    v = 1 - v;
  }
  return {(std::copysign(u, d.x) + 1) / 2, (std::copysign(v, d.y) + 1) / 2};
}

glm::dvec3 octahedral_direction(const glm::dvec2& square) {
  const double x = 2 * square.x - 1, y = 2 * square.y - 1;
  const double u = std::abs(x), v = std::abs(y), depth = 1 - u - v;
  const double r = 1 - std::abs(depth);
  const double phi = r == 0 ? 0 : ((v - u) / r + 1) * kPi / 4;
  const double ring = r * std::sqrt(std::max(0.0, 2 - r * r));
  return {std::copysign(ring * std::cos(phi), x), std::copysign(ring * std::sin(phi), y),
          std::copysign(1 - r * r, depth)};
}

}  // namespace

glm::dvec2 square_of_direction(SphereMap map, const glm::dvec3& d) {
  if (map == SphereMap::octahedral) return octahedral_square(d);
  const double turn = std::atan2(d.y, d.x) / (2 * kPi);
  return {turn < 0 ? std::min(turn + 1, std::nextafter(1.0, 0.0)) : turn,
          std::atan2(std::hypot(d.x, d.y), d.z) / kPi};
}

glm::dvec3 direction_of_square(SphereMap map, const glm::dvec2& square) {
  if (map == SphereMap::octahedral) return octahedral_direction(square);
  const double phi = 2 * kPi * square.x, theta = kPi * square.y;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double texel_solid_angle(SphereMap map, int width, int height, int y) {
  if (map == SphereMap::octahedral) return 4 * kPi / width / height;
  return 2 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
}

glm::dvec3 sphere_texel(SphereMap map, const Image& image, int x, int y) {
  const int w = image.width, h = image.height;
  if (map == SphereMap::lat_long) {
    x = (x % w + w) % w;
    y = std::clamp(y, 0, h - 1);
  } else {
    // An edge is folded at its middle: beyond it is the texel that mirrors this one along the edge.
    if (x < 0 || x >= w) x = x < 0 ? -1 - x : 2 * w - 1 - x, y = h - 1 - y;
    if (y < 0 || y >= h) y = y < 0 ? -1 - y : 2 * h - 1 - y, x = w - 1 - x;
    x = std::clamp(x, 0, w - 1);
    y = std::clamp(y, 0, h - 1);
  }
  glm::dvec3 rgb;
  for (int c = 0; c < 3; ++c) {
    const double value = image.at(x, y, image.channels == 1 ? 0 : c);
    rgb[c] = value > 0 && std::isfinite(value) ? value : 0;
  }
  return rgb;
}

glm::dvec3 sphere_lookup(SphereMap map, const Image& image, const glm::dvec3& direction) {
  const glm::dvec2 square = square_of_direction(map, direction);
  const double x = square.x * image.width - 0.5, y = square.y * image.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  glm::dvec3 sum(0);
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner & 1, below = corner >> 1;
    const double weight = (right ? x - left : 1 - (x - left)) * (below ? y - top : 1 - (y - top));
    sum += weight * sphere_texel(map, image, static_cast<int>(left) + right, static_cast<int>(top) + below);
  }
  return sum;
}

}  // namespace capcon
