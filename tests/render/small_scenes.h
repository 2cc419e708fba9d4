#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "base/hash.h"
#include "scene/scene.h"

namespace capcon::testing {

/// A camera at `eye` that looks along +z.
inline Camera camera_at(glm::dvec3 eye, double fov) {
  Camera camera;
  camera.camera_to_world = glm::translate(glm::dmat4(1), eye);
  camera.fov_degrees = fov;
  return camera;
}

inline Shape mesh_shape(std::uint32_t mesh) {
  Shape shape;
  shape.mesh = mesh;
  return shape;
}

/// Triangles of all sizes and directions in a box of side 4 before the camera.
inline Scene random_soup(int count, std::uint64_t seed, int width = 48, int height = 40) {
  Scene scene;
  scene.name = "soup";
  scene.film = {width, height, ""};
  scene.camera = camera_at({0, 0, -5}, 50);
  TriangleMesh mesh;
  const auto random = [&](int i, int k) { return uniform64(seed, i, k); };
  for (int i = 0; i < count; ++i) {
    const glm::vec3 centre(4 * random(i, 0) - 2, 4 * random(i, 1) - 2, 4 * random(i, 2) - 2);
    const float size = static_cast<float>(0.05 + 0.6 * random(i, 3) * random(i, 4));
    for (int v = 0; v < 3; ++v) {
      mesh.positions.push_back(centre + size * glm::vec3(random(i, 5 + 3 * v) - 0.5, random(i, 6 + 3 * v) - 0.5, random(i, 7 + 3 * v) - 0.5));
    }
    mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  scene.meshes.push_back(mesh);
  scene.shapes.push_back(mesh_shape(0));
  return scene;
}

/// A floor and a wall with a sphere, a ring and a stretched sphere, some under instances.
inline Scene round_things() {
  Scene scene;
  scene.name = "round";
  scene.film = {48, 40, ""};
  scene.camera = camera_at({0, 1, -4}, 55);
  TriangleMesh floor;
  floor.positions = {{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 5, 5}, {5, 5, 5}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  scene.meshes.push_back(floor);
  scene.shapes.push_back(mesh_shape(0));
  Shape sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.radius = 0.7;
  sphere.to_world = glm::translate(glm::dmat4(1), glm::dvec3(-0.9, 0.7, 0.5));
  scene.shapes.push_back(sphere);
  Shape ring;
  ring.kind = ShapeKind::disk;
  ring.radius = 0.9;
  ring.inner_radius = 0.4;
  ring.height = 0.3;
  ring.to_world = glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(1, 0.9, 0.4)), 1.1, glm::dvec3(1, 0.4, 0.2));
  scene.shapes.push_back(ring);
  Object object;
  object.name = "egg";
  Shape egg = sphere;
  egg.radius = 0.4;
  egg.to_world = glm::scale(glm::dmat4(1), glm::dvec3(1, 1.6, 0.8));
  object.shapes.push_back(egg);
  scene.objects.push_back(object);
  scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(0.2, 0.6, -0.8))});
  scene.instances.push_back({0, glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0.9, 0.4, -1.1)), 0.9, glm::dvec3(0, 0, 1))});
  return scene;
}

}  // namespace capcon::testing
