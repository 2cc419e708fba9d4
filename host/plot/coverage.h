#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace capcon::plot {

/// How much of every pixel of a rectangle [x, x + width) x [y, y + height) a shape covers, 0 .. 1.
struct Coverage {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<float> share;
  bool empty() const { return width <= 0 || height <= 0; }
};

/// Whole pixels; what lies outside is not looked at.
struct PixelBounds {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// The exact area of a simple polygon in each pixel, by the signed areas under its edges.
Coverage cover_polygon(std::span<const glm::dvec2> corners, const PixelBounds& bounds);

/// Lines of one width with round ends: one minus the distance to the nearest of the outlines, within half a
/// pixel of it. Lines that cross cover once. A line thinner than a pixel covers its width's share.
Coverage cover_lines(std::span<const std::vector<glm::dvec2>> lines, double width, const PixelBounds& bounds);

}  // namespace capcon::plot
