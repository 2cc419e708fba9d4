#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/light.h"

namespace capcon::reference {

// What samples on lights and rays that meet them have in common.

inline bool outside(const Light& sphere, const glm::dvec3& origin) {
  return glm::distance(origin, sphere.position) > sphere.radius;
}

/// 1 - cos(theta_max) of the cone under which a sphere is seen from outside.
inline double cone_height(const Light& sphere, const glm::dvec3& origin) {
  const double distance = glm::distance(origin, sphere.position);
  const double cosine2 = (distance - sphere.radius) * (distance + sphere.radius) / (distance * distance);
  const double sine =
      sphere.radius / distance;  // 1 - cosine2 would lose the digits of small and distant spheres
  return sine * sine / (1 + std::sqrt(std::max(0.0, cosine2)));
}

inline glm::dvec3 normal_of(const LightTriangle& t) {
  return glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
}

/// Density in solid angle of points spread evenly over `area`, where one lies at `to` from the origin.
inline double area_pdf(double area, const glm::dvec3& to, const glm::dvec3& normal) {
  const double distance2 = glm::dot(to, to);
  return distance2 * std::sqrt(distance2) / (area * std::abs(glm::dot(to, normal)));
}

/// What a side gives to rays that go in `direction`.
inline glm::dvec3 side_radiance(const Light& light, const glm::dvec3& normal, const glm::dvec3& direction) {
  return light.two_sided || glm::dot(normal, direction) < 0 ? light.radiance : glm::dvec3(0);
}

}  // namespace capcon::reference
