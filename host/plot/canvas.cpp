#include "plot/canvas.h"

#include <array>

namespace capcon::plot {

void Canvas::rectangle(const Box& b, Colour fill) {
  const std::array<glm::dvec2, 4> corners{
      {{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}}};
  polygon(corners, fill);
}

void Canvas::frame(const Box& b, const Stroke& stroke) {
  const std::array<glm::dvec2, 5> corners{
      {{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}, {b.x, b.y}}};
  polyline(corners, stroke);
}

void Canvas::line(glm::dvec2 from, glm::dvec2 to, const Stroke& stroke) {
  const std::array<glm::dvec2, 2> ends{from, to};
  polyline(ends, stroke);
}

}  // namespace capcon::plot
