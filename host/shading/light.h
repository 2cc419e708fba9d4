#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "shading/environment.h"

namespace capcon {

enum class LightKind : std::uint8_t { disk, sphere, rectangle, triangles, environment, distant, point };

/// A triangle of a light in world space; it emits to the side from which a, b, c are counter-clockwise, that
/// is along cross(b - a, c - a).
struct LightTriangle {
  glm::dvec3 a, b, c;
  std::uint32_t primitive = 0;  ///< of the shape: the mesh's triangle; 0 for an ellipsoid
};

/// A light as plain values, in world space. Colours are linear sRGB.
struct Light {
  LightKind kind = LightKind::point;
  /// Disk, sphere, rectangle, triangles: emitted radiance. Environment: what the image is multiplied by, or
  /// the constant radiance. Distant: irradiance of a surface that faces it. Point: intensity, per steradian.
  glm::dvec3 radiance{0};
  bool two_sided = false;  ///< emits from both sides
  bool hidden = false;     ///< no ray meets it (a shape of alpha 0)
  bool inward = false;     ///< sphere, ellipsoid: emits into itself

  glm::dvec3 position{0};  ///< disk, sphere: centre; rectangle: a corner; point
  /// Disk: position + u axis_u + v axis_v with inner^2 <= u^2 + v^2 <= 1, an ellipse where the transform
  /// makes one. Rectangle: u and v in [0, 1], a parallelogram.
  glm::dvec3 axis_u{0}, axis_v{0};
  glm::dvec3 normal{0, 0,
                    1};  ///< unit; disk, rectangle: the emitting side; distant: the way that its light goes
  double radius = 0;     ///< sphere
  double inner = 0;      ///< disk: radius of the hole / radius
  std::uint32_t first_triangle = 0, triangle_count = 0;  ///< triangles: range in Lights::triangles
  double area = 0;                                       ///< of one side; 0 for lights without area

  int environment = -1;    ///< environment with an image: index into Lights::environments; else -1
  glm::dmat3 to_light{1};  ///< environment: orthogonal, world direction to the map's own space

  /// Emitted flux in W; for environment and distant lights what passes through the scene's bounding sphere.
  glm::dvec3 power{0};
};

struct Environment {
  int image = -1;  ///< index into Scene::images
  EnvironmentTable table;
};

struct Lights {
  std::vector<Light> values;
  std::vector<LightTriangle> triangles;
  std::vector<double> areas;  ///< cumulative area of each light's triangles, one a triangle, last = its area
  std::vector<Environment> environments;
  std::vector<int> of_shape;          ///< for each of Scene::shapes its light, -1 for none
  std::vector<std::string> warnings;  ///< "file:line:column: sentence"
};

/// All lights of a scene, area lights of shapes first. Lights that emit nothing are left out. What is
/// approximated (spots and images on lights, environments under a transform that is no rotation, ellipsoids)
/// is said once a light. InputError with its place for values that make no sense.
Lights read_lights(const Scene& scene);

/// Towards a unit direction in world space: the radiance of an environment light.
glm::dvec3 environment_radiance(const Scene& scene, const Lights& lights, const Light& light,
                                const glm::dvec3& direction);

}  // namespace capcon
