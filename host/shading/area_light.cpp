#include "shading/area_light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "scene/tessellate.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dvec3 point(const glm::dmat4& transform, const glm::dvec3& p) {
  return glm::dvec3(transform * glm::dvec4(p, 1));
}

/// The scale of a transform that keeps angles (mirrors may), nothing for others.
std::optional<double> similarity(const glm::dmat3& m) {
  const double scale = glm::length(m[0]);
  const glm::dmat3 product = glm::transpose(m) * m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(product[i][j] - (i == j ? scale * scale : 0)) <= 1e-6 * scale * scale))
        return std::nullopt;
    }
  }
  return scale;
}

Light disk(const Shape& shape) {
  Light light;
  light.kind = LightKind::disk;
  const glm::dmat3 linear(shape.to_world);
  light.position = point(shape.to_world, {0, 0, shape.height});
  light.axis_u = shape.radius * linear[0];
  light.axis_v = shape.radius * linear[1];
  light.inner = shape.inner_radius / shape.radius;
  const glm::dvec3 cross = glm::cross(light.axis_u, light.axis_v);
  light.area = kPi * glm::length(cross) * (1 - light.inner * light.inner);
  // The object's +z, which a mirroring transform keeps on the side of the image of +z.
  const double side = glm::dot(cross, linear[2]) < 0 ? -1 : 1;
  light.normal = (shape.reverse_orientation ? -side : side) * glm::normalize(cross);
  return light;
}

/// Adds the triangles of a mesh. They face as pbrt-v4 says: towards the vertices' normals where there are
/// any, else counter-clockwise in the object's space; ReverseOrientation turns them.
Light triangles(const TriangleMesh& mesh, const Shape& shape, Lights& lights) {
  Light light;
  light.kind = LightKind::triangles;
  light.first_triangle = static_cast<std::uint32_t>(lights.triangles.size());
  const glm::dmat3 linear(shape.to_world);
  const bool mirrors = glm::determinant(linear) < 0;
  const glm::dmat3 of_normals = glm::transpose(glm::inverse(linear));
  const bool tessellated = shape.kind != ShapeKind::mesh;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const glm::uvec3 t = mesh.triangles[k];
    LightTriangle triangle{
        point(shape.to_world, mesh.positions[t.x]), point(shape.to_world, mesh.positions[t.y]),
        point(shape.to_world, mesh.positions[t.z]), tessellated ? 0 : static_cast<std::uint32_t>(k)};
    const glm::dvec3 cross = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    bool turn = mirrors;
    if (!mesh.normals.empty()) {
      const glm::dvec3 sum(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
      turn = glm::dot(cross, of_normals * sum) < 0;
    }
    if (turn != shape.reverse_orientation) std::swap(triangle.b, triangle.c);
    const double area = glm::length(cross) / 2;
    if (!(area > 0)) continue;
    light.area += area;
    lights.triangles.push_back(triangle);
    lights.areas.push_back(light.area);
  }
  light.triangle_count = static_cast<std::uint32_t>(lights.triangles.size()) - light.first_triangle;
  return light;
}

/// Two triangles that make a parallelogram and face one way: b - a and c - a of the one span it.
std::optional<Light> rectangle(const LightTriangle& one, const LightTriangle& two) {
  const glm::dvec3 p[3] = {one.a, one.b, one.c}, q[3] = {two.a, two.b, two.c};
  const glm::dvec3 cross = glm::cross(one.b - one.a, one.c - one.a);
  const double tolerance = 1e-6 * std::sqrt(glm::length(cross));
  if (glm::distance(cross, glm::cross(two.b - two.a, two.c - two.a)) > 1e-6 * glm::length(cross))
    return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 u = p[(i + 1) % 3], v = p[(i + 2) % 3];
    for (int j = 0; j < 3; ++j) {
      // The second triangle runs along the shared edge the other way round.
      const bool shares =
          glm::distance(q[(j + 1) % 3], v) <= tolerance && glm::distance(q[(j + 2) % 3], u) <= tolerance;
      if (!shares || glm::distance(p[i] + q[j], u + v) > tolerance) continue;
      Light light;
      light.kind = LightKind::rectangle;
      light.position = p[i];
      light.axis_u = u - p[i];
      light.axis_v = v - p[i];
      light.normal = glm::normalize(cross);
      light.area = glm::length(cross);
      return light;
    }
  }
  return std::nullopt;
}

Light mesh(const TriangleMesh& source, const Shape& shape, Lights& lights) {
  Light light = triangles(source, shape, lights);
  if (light.triangle_count != 2) return light;
  const std::optional<Light> found =
      rectangle(lights.triangles[light.first_triangle], lights.triangles[light.first_triangle + 1]);
  if (!found) return light;
  lights.triangles.resize(light.first_triangle);
  lights.areas.resize(light.first_triangle);
  return *found;
}

}  // namespace

Light shape_of_light(const Scene& scene, const Shape& shape, Lights& lights, std::string& remark) {
  if (shape.kind == ShapeKind::disk) return disk(shape);
  if (shape.kind == ShapeKind::mesh) return mesh(scene.meshes[shape.mesh], shape, lights);
  if (const std::optional<double> scale = similarity(glm::dmat3(shape.to_world))) {
    Light light;
    light.kind = LightKind::sphere;
    light.position = glm::dvec3(shape.to_world[3]);
    light.radius = *scale * shape.radius;
    light.inward = shape.reverse_orientation;
    light.area = 4 * kPi * light.radius * light.radius;
    return light;
  }
  const TriangleMesh ellipsoid = tessellate_sphere(shape.radius, -shape.radius, shape.radius, 360);
  remark = "its transform makes it an ellipsoid, of which it emits as " +
           std::to_string(ellipsoid.triangles.size()) + " triangles";
  Light light = triangles(ellipsoid, shape, lights);
  light.inward = shape.reverse_orientation;
  return light;
}

}  // namespace capcon
