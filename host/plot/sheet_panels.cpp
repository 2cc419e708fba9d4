#include "plot/sheet_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "plot/measure_sheet.h"
#include "plot/palette.h"

namespace capcon::plot {
namespace {

constexpr double kCropTo = 1024;
constexpr double kWhiteAt = 4;
constexpr Colour kCellBorder{200, 203, 207};

/// Cell polygons, one copy of each for every place where it reaches into [0, side]^2.
template <typename Act>
void for_copies(const VoronoiCell& cell, glm::dvec2 site, double side, const Act& act) {
  glm::dvec2 low(1), high(-1);
  for (const glm::dvec2& c : cell.corners) low = glm::min(low, c), high = glm::max(high, c);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const glm::dvec2 at = site + glm::dvec2(x, y);
      if (at.x + high.x > 0 && at.y + high.y > 0 && at.x + low.x < side && at.y + low.y < side) act(at);
    }
  }
}

std::string figure(double value) {
  if (std::isnan(value)) return "-";
  if (std::abs(value) < 1e-12) return "0";  // rounding
  if (std::abs(value) < 0.01) return fmt::format("{:.2e}", value);
  return fmt::format("{:.4f}", value);
}

}  // namespace

double draw_cells(Canvas& canvas, const Box& box, const Points& points) {
  const auto n = static_cast<double>(points.size());
  const double side = points.size() > kCropAbove ? std::sqrt(kCropTo / n) : 1;
  const auto place = [&](glm::dvec2 p) {
    return glm::dvec2(box.x + p.x / side * box.width, box.bottom() - p.y / side * box.height);
  };
  const double spacing = box.width / std::sqrt(n) / side;
  const Stroke border{kCellBorder, std::clamp(0.06 * spacing, 0.25, 1.0)};
  const std::vector<VoronoiCell> cells = voronoi_cells(points);
  canvas.begin_clip(box);
  for (const bool edges : {false, true}) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].corners.empty()) continue;
      for_copies(cells[i], points[i], side, [&](glm::dvec2 at) {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec2& c : cells[i].corners) corners.push_back(place(at + c));
        const Colour colour = diverging((n * cells[i].area - 1) / 0.5);
        if (!edges) canvas.polygon(corners, colour);
        corners.push_back(corners[0]);
        if (edges) canvas.polyline(corners, border);
      });
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].x <= side && points[i].y <= side)
      canvas.disc(place(points[i]), std::clamp(0.13 * spacing, 0.5, 4.0), kInk);
  }
  canvas.end_clip();
  canvas.frame(box, {kRule, 1});
  return side;
}

void draw_spectrum(Canvas& canvas, const Box& box, const Spectrum& spectrum) {
  Pixels pixels{spectrum.side(), spectrum.side(), {}};
  for (int ky = spectrum.reach; ky >= -spectrum.reach; --ky) {
    for (int kx = -spectrum.reach; kx <= spectrum.reach; ++kx)
      // Noise takes the most room in a file; nobody sees more greys in it than these.
      pixels.colours.push_back(
          grey(kx == 0 && ky == 0 ? 0 : std::round(32 * std::sqrt(spectrum.at(kx, ky) / kWhiteAt)) / 32));
  }
  canvas.image(box, pixels);
}

void draw_figures(Canvas& canvas, const Box& box, const Measures& measures, const RadialSpectrum* radial) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const MeasureField& field : measure_fields())
    rows.emplace_back(field.name, figure(measures.*field.value));
  rows.emplace_back("low power", radial ? figure(radial->low) : "-");
  const double step = 15;
  TextStyle name{.colour = kSoft, .size = 11}, value{.colour = kInk, .size = 11, .anchor = Anchor::kEnd};
  double y = box.y + 11;
  for (const auto& [label, text] : rows) {
    canvas.text({box.x, y}, label, name);
    canvas.text({box.right(), y}, text, value);
    canvas.line({box.x, y + 4}, {box.right(), y + 4}, {kFaint, 1});
    y += step;
  }
}

void draw_legend(Canvas& canvas, glm::dvec2 at, bool stacked) {
  constexpr int kSteps = 60;
  constexpr double kWidth = 120, kHeight = 10;
  const TextStyle name{.colour = kInk, .size = 11, .anchor = Anchor::kEnd};
  const TextStyle tick{.colour = kSoft, .size = 10, .anchor = Anchor::kMiddle};
  const auto bar = [&](const std::string& label, const auto& colour,
                       const std::vector<std::pair<double, std::string>>& ticks) {
    const Box box{at.x + 88, at.y, kWidth, kHeight};
    canvas.text({box.x - 8, at.y + kHeight - 1}, label, name);
    Pixels pixels{kSteps, 1, {}};
    for (int k = 0; k < kSteps; ++k) pixels.colours.push_back(colour((k + 0.5) / kSteps));
    canvas.image(box, pixels);
    canvas.frame(box, {kRule, 1});
    for (const auto& [share, text] : ticks)
      canvas.text({box.x + share * kWidth, box.bottom() + 12}, text, tick);
    at += stacked ? glm::dvec2(0, 32) : glm::dvec2(250, 0);
  };
  bar("n area of cell", [](double t) { return diverging(2 * t - 1); }, {{0, "1/2"}, {0.5, "1"}, {1, "3/2"}});
  bar("power", [](double t) { return grey(t); }, {{0, "0"}, {0.5, "1 = white noise"}, {1, "4"}});
  const double y = at.y + kHeight / 2;
  canvas.line({at.x + 50, y}, {at.x + 80, y}, {kSoft, 1, 3});
  canvas.text({at.x + 88, y + 4}, "independent points", {.colour = kInk, .size = 11});
}

}  // namespace capcon::plot
