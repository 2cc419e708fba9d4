#include "reference/geometry.h"

#include <glm/geometric.hpp>

namespace capcon::reference {

// A surface point is exact to a few ulps of its primitive's coordinates; 64 ulps of the largest keep it
// outside.
Geometry::Geometry(const Scene& scene)
    : primitives(scene), tree(primitives), offset(64 * 0x1p-52 * tree.scale()) {}

std::optional<Seen> Geometry::look(const Ray& ray, const Ignored& ignored, double t_max) const {
  const std::optional<Hit> hit = tree.closest(ray, ignored, t_max);
  if (!hit) return {};
  SurfacePoint at = primitives.surface(hit->primitive, ray, hit->t);
  if (glm::dot(at.normal, ray.direction) > 0) at.normal = -at.normal;
  at.position += offset * at.normal;
  return Seen{at, hit->primitive, hit->t, primitives.flat(hit->primitive) ? hit->primitive : Ignored::kNone};
}

}  // namespace capcon::reference
