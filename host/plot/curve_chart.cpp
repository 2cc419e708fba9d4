#include "plot/curve_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/palette.h"

namespace capcon::plot {

void draw_curve(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, std::span<const Level> levels,
                std::span<const glm::dvec2> curve, Colour colour) {
  const auto place = [&](double u, double v) {
    return glm::dvec2(box.x + (u - x.low) / (x.high - x.low) * box.width,
                      box.bottom() - (v - y.low) / (y.high - y.low) * box.height);
  };
  const TextStyle small{.colour = kSoft, .size = 10};
  for (const double tick : x.ticks) {
    const double at = place(tick, 0).x;
    canvas.line({at, box.y}, {at, box.bottom()}, {kFaint, 1});
    TextStyle style = small;
    style.anchor = Anchor::kMiddle;
    canvas.text({at, box.bottom() + 13}, fmt::format("{:g}", tick), style);
  }
  for (const double tick : y.ticks) {
    const double at = place(0, tick).y;
    canvas.line({box.x, at}, {box.right(), at}, {kFaint, 1});
    TextStyle style = small;
    style.anchor = Anchor::kEnd;
    canvas.text({box.x - 5, at + 3.5}, fmt::format("{:g}", tick), style);
  }
  canvas.frame(box, {kRule, 1});
  for (const Level& level : levels) {
    const double at = place(0, level.y).y;
    canvas.line({box.x, at}, {box.right(), at}, {kSoft, 1, 3});
  }
  std::vector<std::vector<glm::dvec2>> lines(1);  // a NaN breaks the curve
  // Far outside is outside: coordinates stay small numbers in the file.
  for (const glm::dvec2& p : curve) {
    if (std::isnan(p.y)) {
      lines.emplace_back();
      continue;
    }
    const glm::dvec2 q = place(p.x, p.y);
    lines.back().emplace_back(q.x, std::clamp(q.y, box.y - 4 * box.height, box.bottom() + 4 * box.height));
  }
  canvas.begin_clip(box);
  for (const auto& line : lines) {
    if (line.size() > 1) canvas.polyline(line, {colour, 1.6});
    if (line.size() == 1) canvas.disc(line[0], 1.3, colour);
  }
  canvas.end_clip();
  for (const Level& level : levels) {
    TextStyle style = small;
    style.anchor = Anchor::kEnd;
    canvas.text({box.right() - 4, place(0, level.y).y - 4}, level.name, style);
  }
  const TextStyle name{.colour = kInk, .size = 11, .anchor = Anchor::kMiddle};
  canvas.text({box.x + box.width / 2, box.bottom() + 27}, x.label, name);
  TextStyle turned = name;
  turned.upwards = true;
  canvas.text({box.x - 30, box.y + box.height / 2}, y.label, turned);
}

}  // namespace capcon::plot
