#include "reference/round_shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace capcon::reference {

double intersect_sphere(const Ray& ray, double radius, double t_max) {
  // |o + t d|^2 = r^2 with half the linear coefficient. The discriminant comes from the point of closest
  // approach, which does not cancel for far origins, and the roots are r1 = q / a, r2 = c / q without
  // subtracting near-equal numbers.
  const double a = glm::dot(ray.direction, ray.direction);
  const double half_b = glm::dot(ray.origin, ray.direction);
  const glm::dvec3 closest = ray.origin - (half_b / a) * ray.direction;
  const double discriminant = a * (radius * radius - glm::dot(closest, closest));
  if (!(discriminant >= 0)) return -1;
  const double distance = glm::length(ray.origin);
  const double c = (distance - radius) * (distance + radius);
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  double near = q / a;
  double far = q != 0 ? c / q : near;
  if (near > far) std::swap(near, far);
  if (near > 0) return near <= t_max ? near : -1;
  return far > 0 && far <= t_max ? far : -1;
}

double intersect_disk(const Ray& ray, double height, double inner_radius, double radius, double t_max) {
  if (ray.direction.z == 0) return -1;
  const double t = (height - ray.origin.z) / ray.direction.z;
  if (!(t > 0 && t <= t_max)) return -1;
  const double x = ray.origin.x + t * ray.direction.x;
  const double y = ray.origin.y + t * ray.direction.y;
  const double r2 = x * x + y * y;
  return r2 >= inner_radius * inner_radius && r2 <= radius * radius ? t : -1;
}

}  // namespace capcon::reference
