#include "render/view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace capcon {
namespace {

constexpr double kFar = 16;  // radii of the scene from which on rays start before it

}  // namespace

View make_view(const Camera& camera, int width, int height) {
  const double aspect =
      camera.frame_aspect_ratio > 0 ? camera.frame_aspect_ratio : static_cast<double>(width) / height;
  auto [x_min, x_max, y_min, y_max] = camera.screen;
  if (x_min == x_max) {
    x_max = std::max(aspect, 1.0);
    y_max = std::max(1 / aspect, 1.0);
    x_min = -x_max;
    y_min = -y_max;
  }
  const double tangent = std::tan(glm::radians(camera.fov_degrees) / 2);
  const auto direction = [&](double x, double y) {
    return glm::dvec3(camera.camera_to_world * glm::dvec4(x * tangent, y * tangent, 1, 0));
  };
  View view;
  view.eye = glm::dvec3(camera.camera_to_world[3]);
  view.corner = direction(x_min, y_max);
  view.across = (direction(x_max, y_max) - view.corner) / static_cast<double>(width);
  view.down = (direction(x_min, y_min) - view.corner) / static_cast<double>(height);
  view.first = view.eye;
  return view;
}

View make_view(const Camera& camera, int width, int height, const Placement& placement,
               const BoundingSphere& bounds) {
  Camera placed = camera;
  placed.camera_to_world = placement.matrix() * camera.camera_to_world;
  View view = make_view(placed, width, height);
  const glm::dvec3 forward(placed.camera_to_world[2]);  // as long as directions are deep
  const double radius = placement.scale * bounds.radius;
  const double depth =
      glm::dot(placement.to_device(bounds.centre) - view.eye, forward) / glm::length(forward);
  if (depth > kFar * radius) {
    view.start = (depth - 2 * radius) / glm::length(forward);
    view.first = view.eye + view.start * view.corner;
  }
  return view;
}

}  // namespace capcon
