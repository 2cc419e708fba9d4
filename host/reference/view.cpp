#include "reference/view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

namespace capcon::reference {

View::View(const Camera& camera, const Film& film)
    : camera_to_world_(camera.camera_to_world),
      half_width_(std::tan(glm::radians(camera.fov_degrees) / 2)),
      x_min_(camera.screen[0]),
      x_max_(camera.screen[1]),
      y_min_(camera.screen[2]),
      y_max_(camera.screen[3]),
      width_(film.width),
      height_(film.height) {
  if (camera.screen != std::array<double, 4>{0, 0, 0, 0}) return;
  const double aspect = camera.frame_aspect_ratio != 0 ? camera.frame_aspect_ratio : double(width_) / height_;
  x_max_ = aspect >= 1 ? aspect : 1;  // the shorter axis spans [-1, 1]
  y_max_ = aspect >= 1 ? 1 : 1 / aspect;
  x_min_ = -x_max_;
  y_min_ = -y_max_;
}

Ray View::ray(double film_x, double film_y) const {
  const double screen_x = x_min_ + (x_max_ - x_min_) * film_x / width_;
  const double screen_y = y_max_ - (y_max_ - y_min_) * film_y / height_;
  const glm::dvec4 direction(screen_x * half_width_, screen_y * half_width_, 1, 0);
  return {glm::dvec3(camera_to_world_[3]), glm::normalize(glm::dvec3(camera_to_world_ * direction))};
}

}  // namespace capcon::reference
