#pragma once

#include <span>
#include <string>
#include <vector>

#include "plot/canvas.h"

namespace capcon::plot {

/// A linear axis: its ends and the ticks that carry labels.
struct Axis {
  double low = 0, high = 1;
  std::vector<double> ticks;
  std::string label;
};

/// A dashed level across the chart, named at its right end.
struct Level {
  double y;
  std::string name;
};

/// A small line chart in `box` (the frame; labels lie outside: 40 left, 32 below): faint grid, dashed levels
/// and one curve, broken where it is NaN.
void draw_curve(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, std::span<const Level> levels,
                std::span<const glm::dvec2> curve, Colour colour);

}  // namespace capcon::plot
