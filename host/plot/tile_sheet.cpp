#include "plot/tile_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/curve_chart.h"
#include "plot/palette.h"
#include "plot/sheet_panels.h"
#include "plot/tiling_panel.h"

namespace capcon::plot {
namespace {

constexpr double kMargin = 20, kSquare = 310, kGap = 20;
constexpr double kTilingsTop = 64, kPlotsTop = 480, kPlots = 270;
constexpr std::uint32_t kWidths[] = {4, 8, 16};

std::string percent(double ratio) {
  return fmt::format("{:+.1f} %", 100 * (ratio - 1));
}

// The figures of one tiling below it: name, value, difference from untiled points.
void draw_row(Canvas& canvas, double x, double y, const std::string& name, double value, double untiled) {
  const TextStyle soft{.colour = kSoft, .size = 11},
      right{.colour = kInk, .size = 11, .anchor = Anchor::kEnd};
  canvas.text({x, y}, name, soft);
  canvas.text({x + 0.55 * kSquare, y}, fmt::format("{:.4f}", value), right);
  TextStyle difference = right;
  difference.colour = kSoft;
  canvas.text({x + kSquare, y}, untiled > 0 ? percent(value / untiled) : "", difference);
  canvas.line({x, y + 4}, {x + kSquare, y + 4}, {kFaint, 1});
}

// A circle, for marks that must not hide what is inside.
void ring(Canvas& canvas, glm::dvec2 centre, double radius, Colour colour) {
  constexpr int kSides = 24;
  std::vector<glm::dvec2> corners;
  for (int k = 0; k <= kSides; ++k) {
    const double angle = 2 * M_PI * k / kSides;
    corners.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  canvas.polyline(corners, {colour, 1});
}

}  // namespace

TileSheetData tile_sheet_data(const std::string& name, const TileSet& set, const TileReportOptions& options) {
  TileSheetData data{name, set, examine_tiles(set, options), {}, options.tilings};
  for (const std::uint32_t width : kWidths)
    data.sizes.push_back(tiling_figures(set, width, 0, set.points_per_tile, options.tilings, 1));
  return data;
}

void TileSheet::draw(Canvas& canvas) const {
  const TileSet& set = data_.set;
  canvas.text({kMargin, 28},
              fmt::format("{}: {} tiles of {} points", data_.name, set.tile_count(), set.points_per_tile),
              {.colour = kInk, .size = 18, .bold = true});
  canvas.text({kMargin, 47}, set.recipe, {.colour = kSoft, .size = 11});
  draw_tilings(canvas, kTilingsTop);
  const auto box = [](int column) {
    return Box{kMargin + column * (kSquare + kGap) + (column > 0 ? 44 : 0), kPlotsTop,
               column > 0 ? kSquare - 44 : kPlots, kPlots};
  };
  draw_spectrum_panel(canvas, box(0));
  draw_radial(canvas, box(1));
  draw_prefixes(canvas, box(2));
}

void TileSheet::draw_tilings(Canvas& canvas, double top) const {
  const Measures& untiled = data_.report.untiled;
  for (int k = 0; k < 3; ++k) {
    const double x = kMargin + k * (kSquare + kGap), below = top + kSquare + 20;
    draw_tiling(canvas, {x, top, kSquare, kSquare}, data_.set, {kWidths[k], 0, 1});
    const TilingFigures& f = data_.sizes[k];
    canvas.text({x, below}, fmt::format("{0} x {0} tiles, {1} points", kWidths[k], f.tiles * f.ranks),
                {.colour = kInk, .size = 12, .bold = true});
    canvas.text({x + kSquare, below}, fmt::format("to untiled, n = {}", untiled.n),
                {.colour = kSoft, .size = 10, .anchor = Anchor::kEnd});
    draw_row(canvas, x, below + 17, "energy", f.energy, untiled.energy);
    draw_row(canvas, x, below + 33, "delta_mean", f.delta_mean, untiled.delta_mean);
    draw_row(canvas, x, below + 49, "delta_min", f.delta_min, untiled.delta_min);
  }
}

void TileSheet::draw_spectrum_panel(Canvas& canvas, const Box& box) const {
  const Spectrum& spectrum = data_.report.spectrum;
  draw_spectrum(canvas, box, spectrum);
  const double pixel = box.width / spectrum.side();
  const auto place = [&](double kx, double ky) {
    return glm::dvec2(box.x + (kx + spectrum.reach + 0.5) * pixel,
                      box.bottom() - (ky + spectrum.reach + 0.5) * pixel);
  };
  const int side = TileReport::kSide;
  for (int k = -spectrum.reach / side * side; k <= spectrum.reach; k += side) {  // ticks at the multiples
    const double length = k == 0 ? 7 : 4;
    const glm::dvec2 x = place(k, 0), y = place(0, k);
    canvas.line({x.x, box.bottom()}, {x.x, box.bottom() + length}, {kSoft, 1});
    canvas.line({box.right(), y.y}, {box.right() + length, y.y}, {kSoft, 1});
  }
  const double radius = std::max(3.0, 1.5 * pixel);
  for (const glm::ivec2 k :
       {glm::ivec2(side, 0), glm::ivec2(-side, 0), glm::ivec2(0, side), glm::ivec2(0, -side)})
    ring(canvas, place(k.x, k.y), radius, {110, 190, 255});
  const Spike& spike = data_.report.spike;
  for (const int sign : {1, -1})
    ring(canvas, place(sign * spike.kx, sign * spike.ky), radius, {255, 150, 60});
  const TextStyle soft{.colour = kSoft, .size = 11};
  canvas.text({box.x, box.bottom() + 22},
              fmt::format("mean spectrum of {} tilings of {} x {} tiles", data_.tilings, side, side), soft);
  canvas.text({box.x, box.bottom() + 37}, "ticks: multiples of the tile frequency; blue: once it", soft);
  canvas.text({box.x, box.bottom() + 52},
              fmt::format("orange: stands out most, {:.2f} times around it", spike.ratio()), soft);
}

void TileSheet::draw_radial(Canvas& canvas, const Box& box) const {
  const RadialSpectrum radial = radial_spectrum(data_.report.spectrum);
  std::vector<glm::dvec2> curve;
  for (std::size_t r = 0; r < radial.frequency.size(); ++r)
    curve.emplace_back(radial.frequency[r], radial.mean[r]);
  const double high = std::max(2.0, std::ceil(radial.peak));
  Axis power{0, high, {}, "radial mean power"};
  for (double tick = 0; tick <= high; ++tick) power.ticks.push_back(tick);
  const Level white[] = {{1, ""}};
  const Axis frequency{0, 2, {0, 0.5, 1, 1.5, 2}, "frequency / \u221an"};
  draw_curve(canvas, box, frequency, power, white, curve, kBlue);
  // Multiples of the tile frequency lie at whole parts of sqrt(nt).
  const double step = 1 / std::sqrt(double(data_.set.points_per_tile));
  for (double f = step; f < 2 + step / 2; f += step) {
    const double x = box.x + std::min(f / 2, 1.0) * box.width;
    canvas.line({x, box.bottom() - 5}, {x, box.bottom()}, {kRed, 1});
  }
  canvas.text({box.x, box.y - 6}, "red: multiples of the tile frequency", {.colour = kSoft, .size = 11});
}

void TileSheet::draw_prefixes(Canvas& canvas, const Box& box) const {
  const auto& prefixes = data_.report.prefixes;
  std::vector<glm::dvec2> curve;
  for (const TilingFigures& f : prefixes) curve.emplace_back(f.ranks, f.delta_mean);
  const auto nt = double(prefixes.size());
  Axis ranks{0, nt, {}, "points taken of every tile"};
  const double step = std::max(1.0, nt / 8);
  for (double tick = 0; tick <= nt; tick += step) ranks.ticks.push_back(std::round(tick));
  const Axis distance{0.4, 1, {0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}, "delta_mean"};
  const Level levels[] = {{TileReport::kPrefix, fmt::format("{:.2f}", TileReport::kPrefix)},
                          {data_.report.untiled.delta_mean, "untiled"}};
  draw_curve(canvas, box, ranks, distance, levels, curve, kBlue);
  const TilingFigures& worst = data_.report.worst_prefix();
  canvas.text({box.x, box.y - 6},
              fmt::format("ranks: least {:.3f}, at {} points", worst.delta_mean, worst.ranks),
              {.colour = kSoft, .size = 11});
}

}  // namespace capcon::plot
