#include "stability/scenes.h"

#include <fmt/format.h>

#include <array>

namespace capcon::stability {
namespace {

std::string numbers(const glm::dvec3& p) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", p.x, p.y, p.z);
}

}  // namespace

std::string camera(const glm::dvec3& eye, const glm::dvec3& at, double fov, const Place& place,
                   const glm::dvec3& up, int width, int height) {
  const glm::dvec3 from = place.scale * eye + place.offset, to = place.scale * at + place.offset;
  return fmt::format(
      "LookAt {}  {}  {}\nCamera \"perspective\" \"float fov\" {:.17g}\nFilm \"rgb\" \"integer xresolution\" "
      "{} "
      "\"integer yresolution\" {}\n",
      numbers(from), numbers(to), numbers(up), fov, width, height);
}

std::string world(const std::string& text, const Place& place) {
  return fmt::format("WorldBegin\nTranslate {}\nScale {:.17g} {:.17g} {:.17g}\n{}", numbers(place.offset),
                     place.scale, place.scale, place.scale, text);
}

std::string within(const std::string& text) {
  return "AttributeBegin\n" + text + "AttributeEnd\n";
}

std::string matte(double albedo) {
  return fmt::format("Material \"diffuse\" \"rgb reflectance\" [{0} {0} {0}]\n", albedo);
}

std::string lamp(const std::string& shape, double radiance) {
  return within(fmt::format("AreaLightSource \"diffuse\" \"rgb L\" [{0} {0} {0}]\n{1}", radiance, shape));
}

std::string parallelogram(const glm::dvec3& p, const glm::dvec3& u, const glm::dvec3& v) {
  return fmt::format("Shape \"trianglemesh\" \"point3 P\" [{} {} {} {}] \"integer indices\" [0 1 2 0 2 3]\n",
                     numbers(p), numbers(p + u), numbers(p + u + v), numbers(p + v));
}

std::string triangles(const std::vector<glm::dvec3>& points) {
  std::string positions, indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    positions += numbers(points[i]) + "\n";
    indices += fmt::format("{} ", i);
  }
  return "Shape \"trianglemesh\" \"point3 P\" [\n" + positions + "] \"integer indices\" [" + indices + "]\n";
}

std::string box(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 s = high - low, x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
  return parallelogram(low, y, x) + parallelogram(low, x, z) + parallelogram(low, z, y) +
         parallelogram(high, -y, -z) + parallelogram(high, -x, -y) + parallelogram(high, -z, -x);
}

std::string room() {
  return matte(0.6) + parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}) +
         parallelogram({-2, 2, 0}, {4, 0, 0}, {0, 0, 3}) + parallelogram({-2, -2, 0}, {0, 4, 0}, {0, 0, 3}) +
         within("Translate .8 .6 0 Rotate 25 0 0 1\n" + box({-.4, -.4, 0}, {.4, .4, 1.1})) +
         within("Translate -.7 .2 .5\nShape \"sphere\" \"float radius\" .5\n") +
         within(matte(0.3) + "Translate -.2 -.9 .35 Rotate 20 1 .3 0\n" + box({-.5, -.3, 0}, {.5, .3, .02})) +
         lamp("Translate .3 .1 2.6 Scale 1 1 -1\nShape \"disk\" \"float radius\" .5\n", 5);
}

std::string room_camera(const Place& place) {
  return camera({1.1, -4.6, 1.9}, {-.05, .2, .8}, 38, place);
}

std::string stage(const std::string& floor_material) {
  return within(floor_material + parallelogram({-50, -50, 0}, {100, 0, 0}, {0, 100, 0})) +
         within(matte(0.4) + "Translate -.5 .3 .45\nShape \"sphere\" \"float radius\" .35\n") +
         within(matte(0.4) + triangles({{.3, -.5, .3}, {1.1, -.3, .6}, {.6, .5, .4}}));
}

std::string stage_camera() {
  return camera({.4, -4.3, 3.1}, {0.03, 0, 0.12}, 30);
}

}  // namespace capcon::stability
