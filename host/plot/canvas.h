#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace capcon::plot {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

/// A rectangle in the sheet's units (pixels at scale 1), y downwards.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

struct Stroke {
  Colour colour;
  double width = 1;
  double dash = 0;  ///< length of dashes and gaps; 0 = solid
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  Colour colour;
  double size = 12;  ///< of the font; a capital is 0.72 of it
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, read from below
};

/// A grid of colours, row by row from the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<Colour> colours;
};

/// What pictures are drawn on, so that drawing code is written once: flat shapes, painted in the order of the
/// calls. Back ends: SvgCanvas, RasterCanvas.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void polygon(std::span<const glm::dvec2> corners, Colour fill) = 0;
  /// Round joins and ends.
  virtual void polyline(std::span<const glm::dvec2> points, const Stroke& stroke) = 0;
  virtual void disc(glm::dvec2 centre, double radius, Colour fill) = 0;
  /// UTF-8; `at` is where the base line starts, is halved or ends.
  virtual void text(glm::dvec2 at, std::string_view text, const TextStyle& style) = 0;
  /// Fills the box; pixels keep their edges when they are enlarged.
  virtual void image(const Box& box, const Pixels& pixels) = 0;
  /// From here on nothing is painted outside the box, until end_clip. No nesting.
  virtual void begin_clip(const Box& box) = 0;
  virtual void end_clip() = 0;

  void rectangle(const Box& box, Colour fill);
  void frame(const Box& box, const Stroke& stroke);
  void line(glm::dvec2 from, glm::dvec2 to, const Stroke& stroke);
};

}  // namespace capcon::plot
