#include "render/placement.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace capcon {
namespace {

constexpr double kSmallest = 1.0 / 16, kLargest = 4096;  // radii that floats take as they are
constexpr double kGridCells = 4;                         // of the origin's grid, a radius
constexpr double kNear = 2;  // radii from the world's origin that cost no more than a digit

}  // namespace

glm::dmat4 Placement::matrix() const {
  return glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(scale)), -origin);
}

Placement place_scene(const BoundingSphere& bounds, const glm::dvec3& camera) {
  Placement placement;
  if (!(bounds.radius > 0) || !std::isfinite(bounds.radius)) return placement;
  // What is near the camera needs the finest coordinates; from outside the whole scene is about as far as it
  // is large.
  const glm::dvec3 away = camera - bounds.centre;
  const double share = std::clamp(2 - glm::length(away) / bounds.radius, 0.0, 1.0);
  const glm::dvec3 middle = bounds.centre + share * away;
  const double power = std::exp2(std::floor(std::log2(bounds.radius)));
  const double cell = power / kGridCells;
  if (glm::length(middle) > kNear * bounds.radius) placement.origin = cell * glm::round(middle / cell);
  if (bounds.radius < kSmallest || bounds.radius > kLargest) placement.scale = 1 / power;
  return placement;
}

void place_lights(Lights& lights, const Placement& placement) {
  const double length = placement.scale, area = length * length;
  for (Light& light : lights.values) {
    if (light.kind == LightKind::point) light.radiance *= area;
    light.position = placement.to_device(light.position);
    light.axis_u *= length;
    light.axis_v *= length;
    light.radius *= length;
    light.area *= area;
    light.power *= area;
  }
  for (LightTriangle& triangle : lights.triangles) {
    for (glm::dvec3* p : {&triangle.a, &triangle.b, &triangle.c}) *p = placement.to_device(*p);
  }
  for (double& sum : lights.areas) sum *= area;
}

}  // namespace capcon
