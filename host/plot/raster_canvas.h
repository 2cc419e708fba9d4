#pragma once

#include "plot/canvas.h"
#include "plot/coverage.h"

namespace capcon::plot {

/// Paints pixels with smooth edges; text in strokes of our own (glyphs.h). `scale` pixels a unit of the
/// sheet.
class RasterCanvas : public Canvas {
 public:
  RasterCanvas(double width, double height, Colour background, double scale = 1);

  void polygon(std::span<const glm::dvec2> corners, Colour fill) override;
  void polyline(std::span<const glm::dvec2> points, const Stroke& stroke) override;
  void disc(glm::dvec2 centre, double radius, Colour fill) override;
  void text(glm::dvec2 at, std::string_view text, const TextStyle& style) override;
  void image(const Box& box, const Pixels& pixels) override;
  void begin_clip(const Box& box) override;
  void end_clip() override;

  const Pixels& pixels() const { return pixels_; }

 private:
  void blend(const Coverage& coverage, Colour colour);

  double scale_;
  Pixels pixels_;
  PixelBounds clip_;
};

}  // namespace capcon::plot
