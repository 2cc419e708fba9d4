#pragma once

#include "reference/primitives.h"
#include "scene/scene.h"

namespace capcon::reference {

/// A perspective camera over a film, as pbrt-v4 defines it.
class View {
 public:
  View(const Camera& camera, const Film& film);
  /// The ray through a place of the film in pixels, (0, 0) at its upper left corner, y downwards.
  Ray ray(double film_x, double film_y) const;

 private:
  glm::dmat4 camera_to_world_;
  double half_width_;  ///< tan of half the field of view
  double x_min_, x_max_, y_min_, y_max_;
  int width_, height_;
};

}  // namespace capcon::reference
