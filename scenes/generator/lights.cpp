#include "generator/lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "generator/mesh.h"

namespace capcon::scenes {

namespace {
/// 1 where `distance` is below 0, 0 above, soft over a texel.
double inside(double distance, double texel) {
  return std::clamp(0.5 - distance / texel, 0.0, 1.0);
}
}  // namespace

Image painted_tile(int size) {
  const Vec3 glaze(0.8, 0.78, 0.7), blue(0.06, 0.14, 0.42), ochre(0.72, 0.42, 0.08), line(0.3, 0.36, 0.5);
  Image image(size, size, 3);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double u = (x + 0.5) / size, v = (y + 0.5) / size, texel = 1.0 / size;
      Vec3 colour = glaze;
      const auto paint = [&](const Vec3& paint, double distance) {
        colour = glm::mix(colour, paint, inside(distance, texel));
      };
      const double a = u - 0.5, b = v - 0.5, r = std::hypot(a, b), angle = std::atan2(b, a);
      paint(blue, r - 0.24 * (1 + 0.34 * std::cos(8 * angle)));
      paint(ochre, r - 0.12 * (1 + 0.2 * std::cos(8 * angle)));
      paint(glaze, r - 0.05);
      const double c = std::min(u, 1 - u), d = std::min(v, 1 - v), corner = std::hypot(c, d);
      const double petals = 1 + 0.22 * std::cos(8 * std::atan2(d, c));
      paint(blue, std::abs(corner - 0.27 * petals) - 0.025);
      paint(ochre, corner - 0.13 * petals);
      paint(line, std::min(c, d) - 0.008);
      for (int k = 0; k < 3; ++k) image.at(x, y, k) = static_cast<float>(colour[k]);
    }
  }
  return image;
}

void write_lights_data(const std::filesystem::path& folder) {
  write_png(folder / "tile.png", painted_tile(256));
}

}  // namespace capcon::scenes
