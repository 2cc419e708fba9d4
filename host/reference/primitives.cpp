#include "reference/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "reference/round_shapes.h"
#include "shading/scene_bounds.h"

namespace capcon::reference {
namespace {

using glm::cross;
using glm::dot;
using glm::dvec3;

constexpr double kMiss = -1;

dvec3 transform_point(const glm::dmat4& m, const dvec3& p) {
  return dvec3(m * glm::dvec4(p, 1));
}
dvec3 transform_vector(const glm::dmat4& m, const dvec3& v) {
  return dvec3(m * glm::dvec4(v, 0));
}
Ray transform_ray(const glm::dmat4& m, const Ray& ray) {
  return {transform_point(m, ray.origin), transform_vector(m, ray.direction)};
}

/// Signed areas that the ray makes with the three edges, seen along the ray: the barycentric weights times a
/// common factor. An edge shared by two triangles gives exactly opposite numbers, so that no ray slips
/// between them (Woop et al., "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013).
dvec3 edge_areas(const Ray& ray, const dvec3& a, const dvec3& b, const dvec3& c) {
  const glm::dvec2 p = ray.across(a), q = ray.across(b), r = ray.across(c);
  return {r.x * q.y - r.y * q.x, p.x * r.y - p.y * r.x, q.x * p.y - q.y * p.x};
}

}  // namespace

Ray::Ray(const dvec3& o, const dvec3& d) : origin(o), direction(d) {
  const dvec3 size = glm::abs(d);
  axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  shear = glm::dvec2(d[(axis + 1) % 3], d[(axis + 2) % 3]) / d[axis];
}

void Box::grow(const Box& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

Primitives::Primitives(const Scene& scene) {
  const BoundingSphere bounds = scene_bounds(scene);
  rounded_ = glm::length(bounds.centre) <= 2 * bounds.radius;
  for (const Shape& shape : scene.shapes) add(scene, shape, nullptr);
  for (const Instance& instance : scene.instances) {
    for (const Shape& shape : scene.objects.at(instance.object).shapes) add(scene, shape, &instance);
  }
  if (triangles_.size() + round_.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw Failure(
        "the scene has too many instanced triangles for the reference renderer; use a smaller scene");
  }
  for (Placement& placement : round_placements_)
    placement.first += static_cast<std::uint32_t>(triangles_.size());
}

void Primitives::add(const Scene& scene, const Shape& shape, const Instance* instance) {
  const glm::dmat4 to_world = instance ? instance->to_world * shape.to_world : shape.to_world;
  if (shape.kind != ShapeKind::mesh) {
    if (glm::determinant(to_world) == 0) return;  // squashed to nothing
    round_placements_.push_back({&shape, instance, static_cast<std::uint32_t>(round_.size())});
    round_.push_back(
        {shape.kind, shape.radius, shape.inner_radius, shape.height, to_world, glm::inverse(to_world)});
    return;
  }
  const TriangleMesh& mesh = scene.meshes.at(shape.mesh);
  if (mesh.triangles.empty()) return;
  mesh_placements_.push_back({&shape, instance, static_cast<std::uint32_t>(triangles_.size())});
  std::vector<dvec3> world;
  world.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) {
    const dvec3 at = transform_point(to_world, dvec3(p));
    world.push_back(rounded_ ? dvec3(glm::vec3(at)) : at);
  }
  for (const glm::uvec3& t : mesh.triangles) triangles_.push_back({{world[t.x], world[t.y], world[t.z]}});
}

Box Primitives::bounds(std::uint32_t primitive) const {
  if (primitive < triangles_.size()) {
    const Triangle& t = triangles_[primitive];
    return {glm::min(glm::min(t.p[0], t.p[1]), t.p[2]), glm::max(glm::max(t.p[0], t.p[1]), t.p[2])};
  }
  // The image of a sphere reaches radius * |row| along an axis; a disk is the same without its third column.
  const Round& r = round_[primitive - triangles_.size()];
  const bool disk = r.kind == ShapeKind::disk;
  const dvec3 centre = transform_point(r.to_world, {0, 0, disk ? r.height : 0});
  dvec3 reach;
  for (int axis = 0; axis < 3; ++axis) {
    reach[axis] = std::abs(r.radius) * glm::length(dvec3(r.to_world[0][axis], r.to_world[1][axis],
                                                         disk ? 0 : r.to_world[2][axis]));
  }
  reach += 1e-13 * (glm::abs(centre) + reach);
  return {centre - reach, centre + reach};
}

double Primitives::intersect(std::uint32_t primitive, const Ray& ray, double t_max) const {
  if (primitive >= triangles_.size()) {
    const Round& r = round_[primitive - triangles_.size()];
    const Ray local = transform_ray(r.to_object, ray);  // not normalised: the distance stays the world's
    return r.kind == ShapeKind::sphere ? intersect_sphere(local, r.radius, t_max)
                                       : intersect_disk(local, r.height, r.inner_radius, r.radius, t_max);
  }
  const Triangle& t = triangles_[primitive];
  const dvec3 a = t.p[0] - ray.origin;
  const dvec3 b = t.p[1] - ray.origin;
  const dvec3 c = t.p[2] - ray.origin;
  const dvec3 w = edge_areas(ray, a, b, c);
  if ((w.x < 0 || w.y < 0 || w.z < 0) && (w.x > 0 || w.y > 0 || w.z > 0)) return kMiss;
  const dvec3 p0 = t.p[0];
  const dvec3 normal = cross(t.p[1] - p0, t.p[2] - p0);  // of differences without rounding
  const double facing = dot(normal, ray.direction);
  if (facing == 0 || w.x + w.y + w.z == 0) return kMiss;  // seen edge on, or without area
  const double distance = dot(normal, a) / facing;
  return distance > 0 && distance <= t_max ? distance : kMiss;
}

SurfacePoint Primitives::surface(std::uint32_t primitive, const Ray& ray, double t) const {
  if (primitive >= triangles_.size()) {
    const Round& r = round_[primitive - triangles_.size()];
    const Ray local = transform_ray(r.to_object, ray);
    dvec3 p = local.origin + t * local.direction;
    dvec3 normal(0, 0, 1);
    if (r.kind == ShapeKind::disk) {
      p.z = r.height;
    } else {
      normal = glm::normalize(p);
      p = std::abs(r.radius) * normal;
    }
    normal = glm::normalize(glm::transpose(glm::dmat3(r.to_object)) * normal);
    return {transform_point(r.to_world, p), normal, dvec3(0)};
  }
  const Triangle& triangle = triangles_[primitive];
  const dvec3 p0(triangle.p[0]), p1(triangle.p[1]), p2(triangle.p[2]);
  const dvec3 w = edge_areas(ray, p0 - ray.origin, p1 - ray.origin, p2 - ray.origin);
  const double sum = w.x + w.y + w.z;
  return {(w.x * p0 + w.y * p1 + w.z * p2) / sum, glm::normalize(cross(p1 - p0, p2 - p0)), w / sum};
}

bool Primitives::flat(std::uint32_t primitive) const {
  return primitive < triangles_.size() || round_[primitive - triangles_.size()].kind == ShapeKind::disk;
}

const Placement& Primitives::placement(std::uint32_t primitive) const {
  if (primitive >= triangles_.size()) return round_placements_[primitive - triangles_.size()];
  const auto after = std::upper_bound(
      mesh_placements_.begin(), mesh_placements_.end(), primitive,
      [](std::uint32_t value, const Placement& placement) { return value < placement.first; });
  return *(after - 1);
}

}  // namespace capcon::reference
