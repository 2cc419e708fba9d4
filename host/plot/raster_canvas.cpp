#include "plot/raster_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plot/glyphs.h"

namespace capcon::plot {
namespace {

using Lines = std::vector<std::vector<glm::dvec2>>;

/// The line cut into dashes and gaps of one length.
Lines dashes(const std::vector<glm::dvec2>& line, double length) {
  Lines pieces;
  double left = length;
  bool pen = true;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    glm::dvec2 at = line[k];
    double rest = std::hypot(line[k + 1].x - at.x, line[k + 1].y - at.y);
    if (pen && (pieces.empty() || k == 0)) pieces.push_back({at});
    while (rest > left) {
      at += (line[k + 1] - at) * (left / rest);
      rest -= left;
      left = length;
      if (pen)
        pieces.back().push_back(at);
      else
        pieces.push_back({at});
      pen = !pen;
    }
    left -= rest;
    if (pen) pieces.back().push_back(line[k + 1]);
  }
  return pieces;
}

}  // namespace

RasterCanvas::RasterCanvas(double width, double height, Colour background, double scale) : scale_(scale) {
  pixels_.width = int(std::lround(width * scale));
  pixels_.height = int(std::lround(height * scale));
  pixels_.colours.assign(std::size_t(pixels_.width) * pixels_.height, background);
  clip_ = {0, 0, pixels_.width, pixels_.height};
}

void RasterCanvas::blend(const Coverage& coverage, Colour colour) {
  for (int y = 0; y < coverage.height; ++y) {
    for (int x = 0; x < coverage.width; ++x) {
      const float share = coverage.share[std::size_t(y) * coverage.width + x];
      Colour& below = pixels_.colours[std::size_t(coverage.y + y) * pixels_.width + coverage.x + x];
      const auto mix = [share](std::uint8_t from, std::uint8_t to) {
        return std::uint8_t(std::lround(float(from) + share * (float(to) - float(from))));
      };
      below = {mix(below.r, colour.r), mix(below.g, colour.g), mix(below.b, colour.b)};
    }
  }
}

void RasterCanvas::polygon(std::span<const glm::dvec2> corners, Colour fill) {
  std::vector<glm::dvec2> scaled(corners.begin(), corners.end());
  for (glm::dvec2& p : scaled) p *= scale_;
  blend(cover_polygon(scaled, clip_), fill);
}

void RasterCanvas::polyline(std::span<const glm::dvec2> points, const Stroke& stroke) {
  std::vector<glm::dvec2> scaled(points.begin(), points.end());
  for (glm::dvec2& p : scaled) p *= scale_;
  const Lines lines = stroke.dash > 0 ? dashes(scaled, stroke.dash * scale_) : Lines{scaled};
  blend(cover_lines(lines, stroke.width * scale_, clip_), stroke.colour);
}

void RasterCanvas::disc(glm::dvec2 centre, double radius, Colour fill) {
  const Lines point{{centre * scale_}};
  blend(cover_lines(point, 2 * radius * scale_, clip_), fill);
}

void RasterCanvas::text(glm::dvec2 at, std::string_view text, const TextStyle& style) {
  const double size = style.size * scale_, width = text_width(text) * size;
  const double shift = style.anchor == Anchor::kStart    ? 0
                       : style.anchor == Anchor::kMiddle ? width / 2
                                                         : width;
  Lines lines = text_strokes(text);
  for (auto& line : lines) {
    for (glm::dvec2& p : line) {
      const glm::dvec2 q(p.x * size - shift, -p.y * size);
      p = at * scale_ + (style.upwards ? glm::dvec2(q.y, -q.x) : q);
    }
  }
  blend(cover_lines(lines, (style.bold ? 0.125 : 0.085) * size, clip_), style.colour);
}

void RasterCanvas::image(const Box& box, const Pixels& image) {
  const double left = box.x * scale_, top = box.y * scale_;
  const double step_x = image.width / (box.width * scale_), step_y = image.height / (box.height * scale_);
  const int x0 = std::max(clip_.left, int(std::lround(left)));
  const int x1 = std::min(clip_.right, int(std::lround(left + box.width * scale_)));
  const int y0 = std::max(clip_.top, int(std::lround(top)));
  const int y1 = std::min(clip_.bottom, int(std::lround(top + box.height * scale_)));
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      // The mean of the source pixels below this one; the nearest when they are larger.
      const int u0 =
          std::clamp(int((x - left) * step_x + (step_x > 1 ? 0.5 : 0.5 * step_x)), 0, image.width - 1);
      const int v0 =
          std::clamp(int((y - top) * step_y + (step_y > 1 ? 0.5 : 0.5 * step_y)), 0, image.height - 1);
      const int u1 = std::clamp(int((x + 1 - left) * step_x + 0.5), u0 + 1, image.width);
      const int v1 = std::clamp(int((y + 1 - top) * step_y + 0.5), v0 + 1, image.height);
      const int u2 = step_x > 1 ? u1 : u0 + 1, v2 = step_y > 1 ? v1 : v0 + 1;
      std::array<int, 3> sum{};
      for (int v = v0; v < v2; ++v) {
        for (int u = u0; u < u2; ++u) {
          const Colour c = image.colours[std::size_t(v) * image.width + u];
          sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
        }
      }
      const int count = (u2 - u0) * (v2 - v0);
      pixels_.colours[std::size_t(y) * pixels_.width + x] = {
          std::uint8_t(sum[0] / count), std::uint8_t(sum[1] / count), std::uint8_t(sum[2] / count)};
    }
  }
}

void RasterCanvas::begin_clip(const Box& box) {
  clip_ = {std::max(0, int(std::lround(box.x * scale_))), std::max(0, int(std::lround(box.y * scale_))),
           std::min(pixels_.width, int(std::lround(box.right() * scale_))),
           std::min(pixels_.height, int(std::lround(box.bottom() * scale_)))};
}

void RasterCanvas::end_clip() {
  clip_ = {0, 0, pixels_.width, pixels_.height};
}

}  // namespace capcon::plot
