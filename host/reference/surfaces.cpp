#include "reference/surfaces.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace capcon::reference {
namespace {

/// `v` as a unit vector; 0 stays 0.
glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

ShadingPoint Surfaces::at(std::uint32_t primitive, const SurfacePoint& point) const {
  const Placement& placement = primitives_.placement(primitive);
  const Shape& shape = *placement.shape;
  ShadingPoint result{shape.material, glm::dvec3(0), glm::dvec2(0)};
  if (shape.kind != ShapeKind::mesh) return result;
  const TriangleMesh& mesh = scene_.meshes[shape.mesh];
  const glm::uvec3 corners = mesh.triangles[primitive - placement.first];
  if (!mesh.normals.empty()) {
    glm::dmat3 to_world(shape.to_world);
    if (placement.instance) to_world = glm::dmat3(placement.instance->to_world) * to_world;
    const glm::dmat3 of_normals = glm::transpose(glm::inverse(to_world));
    for (int k = 0; k < 3; ++k)
      result.normal += point.weights[k] * unit(of_normals * glm::dvec3(mesh.normals[corners[k]]));
    result.normal = unit(result.normal);
  }
  const glm::dvec2 by_default[3] = {{0, 0}, {1, 0}, {1, 1}};  // pbrt's, for meshes without their own
  for (int k = 0; k < 3; ++k)
    result.uv += point.weights[k] * (mesh.uvs.empty() ? by_default[k] : glm::dvec2(mesh.uvs[corners[k]]));
  return result;
}

}  // namespace capcon::reference
