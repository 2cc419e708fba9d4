#include "fuzz/scene_check.h"

#include <algorithm>
#include <cmath>

#include "fuzz/target.h"

namespace capcon::fuzz {
namespace {

template <int N>
bool is_finite(const glm::vec<N, float>& v) {
  for (int i = 0; i < N; ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}

bool is_finite(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

void check_shapes(const std::vector<Shape>& shapes, const Scene& scene) {
  for (const Shape& shape : shapes) {
    require(shape.kind != ShapeKind::mesh || shape.mesh < scene.meshes.size(), "a shape's mesh is there");
    require(shape.material >= -1 && shape.material < static_cast<int>(scene.materials.size()),
            "a shape's material is there");
    require(shape.area_light >= -1 && shape.area_light < static_cast<int>(scene.area_lights.size()),
            "a shape's area light is there");
    require(shape.radius > 0 && std::isfinite(shape.radius), "a radius is above 0 and finite");
    require(std::isfinite(shape.height) && std::isfinite(shape.inner_radius), "a disk's numbers are finite");
    require(is_finite(shape.to_world), "a shape's transform is finite");
  }
}

void check_images(const std::vector<Entity>& entities, const Scene& scene) {
  for (const Entity& entity : entities)
    require(entity.image >= -1 && entity.image < static_cast<int>(scene.images.size()), "an image is there");
}

}  // namespace

void check_mesh(const TriangleMesh& mesh) {
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner)
      require(triangle[corner] < mesh.positions.size(), "a corner's vertex is there");
  const auto finite = [](const auto& v) { return is_finite(v); };
  require(std::ranges::all_of(mesh.positions, finite), "positions are finite");
  require(std::ranges::all_of(mesh.normals, finite), "normals are finite");
  require(std::ranges::all_of(mesh.uvs, finite), "uvs are finite");
  require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(), "a normal for each vertex");
  require(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size(), "a uv for each vertex");
}

void check_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    require(!warning.empty() && warning == one_line(warning), "a warning is one line");
}

void check_scene(const Scene& scene) {
  for (const TriangleMesh& mesh : scene.meshes) check_mesh(mesh);
  check_shapes(scene.shapes, scene);
  check_shapes(scene.hidden_shapes, scene);
  for (const Object& object : scene.objects) check_shapes(object.shapes, scene);
  for (const Instance& instance : scene.instances) {
    require(instance.object < scene.objects.size(), "an instance's object is there");
    require(is_finite(instance.to_world), "an instance's transform is finite");
  }
  require(scene.film.width >= 1 && scene.film.height >= 1, "an image has pixels");
  require(is_finite(scene.camera.camera_to_world), "the camera's transform is finite");
  require(scene.camera.fov_degrees > 0 && scene.camera.fov_degrees < 180, "a field of view is one");
  for (const auto* entities : {&scene.materials, &scene.lights, &scene.area_lights, &scene.textures})
    check_images(*entities, scene);
  check_warnings(scene.warnings);
}

}  // namespace capcon::fuzz
