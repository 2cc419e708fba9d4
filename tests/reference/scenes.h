#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/scene.h"

namespace capcon::test {

/// Looks from `eye` along `direction` with a narrow view: every pixel sees nearly the same point.
inline Camera camera_at(const glm::dvec3& eye, const glm::dvec3& direction, double fov_degrees = 1e-6) {
  const glm::dvec3 z = glm::normalize(direction);
  const glm::dvec3 helper = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, z));
  const glm::dvec3 y = glm::cross(z, x);
  Camera camera;
  camera.camera_to_world =
      glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
  camera.fov_degrees = fov_degrees;
  return camera;
}

/// Builds scenes in memory.
struct Builder {
  Scene scene;

  explicit Builder(int width = 4, int height = 4) { scene.film = {width, height, ""}; }

  Builder& camera(const glm::dvec3& eye, const glm::dvec3& direction, double fov_degrees = 1e-6) {
    scene.camera = camera_at(eye, direction, fov_degrees);
    return *this;
  }
  Builder& mesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles,
                const glm::dmat4& to_world = glm::dmat4(1)) {
    Shape shape;
    shape.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    shape.to_world = to_world;
    scene.meshes.push_back({std::move(positions), std::move(triangles), {}, {}});
    scene.shapes.push_back(shape);
    return *this;
  }
  /// The parallelogram at `corner` spanned by `a` and `b`, two triangles.
  Builder& quad(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
    return mesh({corner, corner + a, corner + a + b, corner + b}, {{0, 1, 2}, {0, 2, 3}});
  }
  Builder& sphere(double radius, const glm::dmat4& to_world) {
    return round(ShapeKind::sphere, radius, 0, 0, to_world);
  }
  Builder& disk(double radius, double height, double inner_radius, const glm::dmat4& to_world) {
    return round(ShapeKind::disk, radius, height, inner_radius, to_world);
  }

 private:
  Builder& round(ShapeKind kind, double radius, double height, double inner_radius,
                 const glm::dmat4& to_world) {
    Shape shape;
    shape.kind = kind;
    shape.radius = radius;
    shape.height = height;
    shape.inner_radius = inner_radius;
    shape.to_world = to_world;
    scene.shapes.push_back(shape);
    return *this;
  }
};

inline glm::dmat4 move(double x, double y, double z) {
  return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
}

/// The big square [-size, size]^2 in the plane y = 0.
inline Builder& floor(Builder& builder, float size) {
  return builder.quad({-size, 0, -size}, {0, 0, 2 * size}, {2 * size, 0, 0});
}

}  // namespace capcon::test
