#pragma once

#include <cmath>
#include <cstdlib>

#include "scene/scene.h"

namespace capcon::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

/// What the rest of the program takes for granted of a mesh.
inline void check(const TriangleMesh& mesh) {
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) require(triangle[corner] < mesh.positions.size());
  }
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
  require(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
}

inline void check(const Scene& scene) {
  for (const TriangleMesh& mesh : scene.meshes) check(mesh);
  const auto check_shapes = [&](const std::vector<Shape>& shapes) {
    for (const Shape& shape : shapes) {
      require(shape.kind != ShapeKind::mesh || shape.mesh < scene.meshes.size());
      require(shape.material >= -1 && shape.material < static_cast<int>(scene.materials.size()));
      require(shape.area_light >= -1 && shape.area_light < static_cast<int>(scene.area_lights.size()));
      require(shape.radius > 0 && std::isfinite(shape.radius));
    }
  };
  check_shapes(scene.shapes);
  check_shapes(scene.hidden_shapes);
  for (const Object& object : scene.objects) check_shapes(object.shapes);
  for (const Instance& instance : scene.instances) require(instance.object < scene.objects.size());
}

}  // namespace capcon::fuzz
