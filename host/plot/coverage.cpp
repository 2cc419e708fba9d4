#include "plot/coverage.h"

#include <algorithm>
#include <cmath>

namespace capcon::plot {
namespace {

struct Extent {
  glm::dvec2 low{1e9}, high{-1e9};
  void add(std::span<const glm::dvec2> points) {
    for (const glm::dvec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
};

Coverage pixels_of(const Extent& extent, double margin, const PixelBounds& bounds) {
  Coverage c;
  const auto clamped = [](double v, int low, int high) {
    return int(std::clamp(v, double(low), double(high)));
  };
  c.x = clamped(std::floor(extent.low.x - margin), bounds.left, bounds.right);
  c.y = clamped(std::floor(extent.low.y - margin), bounds.top, bounds.bottom);
  c.width = clamped(std::ceil(extent.high.x + margin), bounds.left, bounds.right) - c.x;
  c.height = clamped(std::ceil(extent.high.y + margin), bounds.top, bounds.bottom) - c.y;
  if (!c.empty()) c.share.assign(std::size_t(c.width) * c.height, 0.0f);
  return c;
}

/// Adds the part of one row (y in [0, 1] within it, signed height dy) of an edge from x0 to x1: `cover` holds
/// what an edge adds to its own pixel, the rest goes to all pixels right of it by the running sum.
void add_in_row(std::vector<double>& cover, double x0, double x1, double dy) {
  const int width = int(cover.size()) - 2;
  const auto inside = [&](double x) { return std::clamp(x, 0.0, double(width)); };
  double a = inside(std::min(x0, x1));
  const double b = inside(std::max(x0, x1));
  const double span = std::abs(x1 - x0);
  if (b - a < 1e-12 || span < 1e-12) {  // within one column, or outside the rectangle
    const int column = std::min(int(a), width);
    const double right = column + 1 - (a + b) / 2;
    cover[column] += dy * right;
    cover[column + 1] += dy * (1 - right);
    return;
  }
  // What of the edge lies beyond the left or right side acts there at its full height.
  const double left_part = std::max(0.0, a - std::min(x0, x1)) / span;
  const double right_part = std::max(0.0, std::max(x0, x1) - b) / span;
  cover[0] += dy * left_part;
  cover[width] += dy * right_part;
  while (a < b) {
    const int column = int(a);
    const double end = std::min(b, double(column + 1)), part = dy * (end - a) / span;
    const double right = column + 1 - (a + end) / 2;
    cover[column] += part * right;
    cover[column + 1] += part * (1 - right);
    a = end;
  }
}

}  // namespace

Coverage cover_polygon(std::span<const glm::dvec2> corners, const PixelBounds& bounds) {
  Extent extent;
  extent.add(corners);
  Coverage c = pixels_of(extent, 0, bounds);
  if (c.empty()) return c;
  std::vector<double> cover(std::size_t(c.width) + 2);
  for (int row = 0; row < c.height; ++row) {
    std::fill(cover.begin(), cover.end(), 0.0);
    const double top = c.y + row, bottom = top + 1;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec2 p = corners[k], q = corners[k + 1 < corners.size() ? k + 1 : 0];
      const double y0 = std::clamp(p.y, top, bottom), y1 = std::clamp(q.y, top, bottom);
      if (y0 == y1) continue;
      const double slope = (q.x - p.x) / (q.y - p.y);
      add_in_row(cover, p.x + (y0 - p.y) * slope - c.x, p.x + (y1 - p.y) * slope - c.x, y1 - y0);
    }
    double sum = 0;
    for (int x = 0; x < c.width; ++x) {
      sum += cover[x];
      c.share[std::size_t(row) * c.width + x] = float(std::min(1.0, std::abs(sum)));
    }
  }
  return c;
}

Coverage cover_lines(std::span<const std::vector<glm::dvec2>> lines, double width,
                     const PixelBounds& bounds) {
  Extent extent;
  for (const auto& line : lines) extent.add(line);
  const double drawn = std::max(width, 1.0), fade = width / drawn;
  Coverage c = pixels_of(extent, drawn / 2 + 1, bounds);
  if (c.empty()) return c;
  for (const auto& line : lines) {
    for (std::size_t k = 0; k + 1 < std::max<std::size_t>(line.size(), 2); ++k) {
      const glm::dvec2 p = line[k], q = line[std::min(k + 1, line.size() - 1)], along = q - p;
      Extent piece;
      const glm::dvec2 ends[] = {p, q};
      piece.add(ends);
      const Coverage part = pixels_of(piece, drawn / 2 + 1, {c.x, c.y, c.x + c.width, c.y + c.height});
      const double length2 = std::max(1e-12, along.x * along.x + along.y * along.y);
      for (int y = part.y; y < part.y + part.height; ++y) {
        for (int x = part.x; x < part.x + part.width; ++x) {
          const glm::dvec2 d = glm::dvec2(x + 0.5, y + 0.5) - p;
          const double t = std::clamp((d.x * along.x + d.y * along.y) / length2, 0.0, 1.0);
          const double distance = std::hypot(d.x - t * along.x, d.y - t * along.y);
          float& share = c.share[std::size_t(y - c.y) * c.width + (x - c.x)];
          share = std::max(share, float(fade * std::clamp(drawn / 2 + 0.5 - distance, 0.0, 1.0)));
        }
      }
    }
  }
  return c;
}

}  // namespace capcon::plot
