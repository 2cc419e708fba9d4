#include "render/view.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace capcon {

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
  return view;
}

}  // namespace capcon
