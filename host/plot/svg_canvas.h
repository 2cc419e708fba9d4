#pragma once

#include <string>

#include "plot/canvas.h"

namespace capcon::plot {

/// Writes a self-contained SVG 1.1 document: text stays text, images are embedded as PNG.
class SvgCanvas : public Canvas {
 public:
  SvgCanvas(double width, double height, Colour background);

  void polygon(std::span<const glm::dvec2> corners, Colour fill) override;
  void polyline(std::span<const glm::dvec2> points, const Stroke& stroke) override;
  void disc(glm::dvec2 centre, double radius, Colour fill) override;
  void text(glm::dvec2 at, std::string_view text, const TextStyle& style) override;
  void image(const Box& box, const Pixels& pixels) override;
  void begin_clip(const Box& box) override;
  void end_clip() override;

  /// The document so far.
  std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
  int clips_ = 0;
};

}  // namespace capcon::plot
