// Which primitives are lights', and what rays that meet them bring.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/light_geometry.h"
#include "reference/light_sampling.h"

namespace capcon::reference {

using glm::dot;
using glm::dvec3;
using std::numbers::pi;

LightSampling::LightSampling(const Scene& scene, const Primitives& primitives)
    : scene_(scene), primitives_(primitives), lights_(read_lights(scene)) {
  find_primitives();
}

int LightSampling::of(const Placement& placement) const {
  return placement.instance ? -1 : lights_.of_shape[placement.shape - scene_.shapes.data()];
}

int LightSampling::of_primitive(std::uint32_t primitive) const {
  return of(primitives_.placement(primitive));
}

void LightSampling::find_primitives() {
  ranges_.resize(lights_.values.size());
  triangle_primitives_.assign(lights_.triangles.size(), Ignored::kNone);
  for (const Placement& placement : primitives_.rounds()) {
    const int light = of(placement);
    if (light < 0) continue;
    ranges_[light] = {placement.first, 1};
    // An ellipsoid, of many triangles.
    const Light& l = lights_.values[light];
    std::fill_n(triangle_primitives_.begin() + l.first_triangle, l.triangle_count, placement.first);
  }
  for (const Placement& placement : primitives_.meshes()) {
    const int light = of(placement);
    if (light < 0) continue;
    const TriangleMesh& mesh = scene_.meshes[placement.shape->mesh];
    ranges_[light] = {placement.first, static_cast<std::uint32_t>(mesh.triangles.size())};
    // Triangles without area are no part of the light; the others follow in order.
    const Light& l = lights_.values[light];
    std::uint32_t next = l.first_triangle;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && l.kind == LightKind::triangles; ++t) {
      dvec3 p[3];
      for (int k = 0; k < 3; ++k)
        p[k] = dvec3(placement.shape->to_world * glm::dvec4(mesh.positions[mesh.triangles[t][k]], 1));
      if (glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2 > 0)
        triangle_primitives_.at(next++) = placement.first + t;
    }
    assert(l.kind != LightKind::triangles || next == l.first_triangle + l.triangle_count);
  }
}

bool LightSampling::is_ellipsoid(int light) const {
  const Range& range = ranges_[light];
  return lights_.values[light].kind == LightKind::triangles && range.count > 0 &&
         primitives_.placement(range.first).shape->kind == ShapeKind::sphere;
}

bool LightSampling::findable(int light) const {
  const Light& l = lights_.values[light];
  return !l.hidden && l.kind != LightKind::point && l.kind != LightKind::distant;
}

LightMet LightSampling::meet(int light, std::uint32_t primitive, const Ray& ray, double t) const {
  const Light& l = lights_.values[light];
  const dvec3 to = t * ray.direction;
  dvec3 normal = l.normal;
  if (l.kind == LightKind::sphere) {
    const bool out = outside(l, ray.origin);
    const bool gives = l.two_sided || l.inward != out;
    if (out) return {gives ? l.radiance : dvec3(0), 1 / (2 * pi * cone_height(l, ray.origin))};
    normal = glm::normalize(ray.origin + to - l.position);
    return {gives ? l.radiance : dvec3(0), area_pdf(l.area, to, normal)};
  }
  if (is_ellipsoid(light)) {
    normal = primitives_.surface(primitive, ray, t).normal;
    if (primitives_.placement(primitive).shape->reverse_orientation) normal = -normal;
  } else if (l.kind == LightKind::triangles) {
    const auto first = triangle_primitives_.begin() + l.first_triangle, last = first + l.triangle_count;
    const auto found = std::lower_bound(first, last, primitive);
    if (found == last || *found != primitive) return {};
    normal = normal_of(lights_.triangles[found - triangle_primitives_.begin()]);
  }
  return {side_radiance(l, normal, ray.direction), area_pdf(l.area, to, normal)};
}

LightMet LightSampling::environment(int light, const dvec3& normal, const dvec3& direction) const {
  const Light& l = lights_.values[light];
  if (l.environment < 0) return {l.radiance, std::max(0.0, dot(normal, direction)) / pi};
  const EnvironmentTable& table = lights_.environments[l.environment].table;
  return {environment_radiance(scene_, lights_, l, direction),
          environment_pdf(table, l.to_light * direction)};
}

dvec3 LightSampling::background(const dvec3& direction) const {
  dvec3 sum(0);
  for (const Light& light : lights_.values) {
    if (light.kind == LightKind::environment) sum += environment_radiance(scene_, lights_, light, direction);
  }
  return sum;
}

}  // namespace capcon::reference
