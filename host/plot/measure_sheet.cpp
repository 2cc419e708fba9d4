#include "plot/measure_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/curve_chart.h"
#include "plot/palette.h"
#include "plot/sheet_panels.h"

namespace capcon::plot {
namespace {

constexpr double kMargin = 18, kColumn = 266, kInner = 220, kIndent = 44;
constexpr double kTitle = 40, kGap = 12, kRadial = 110, kAnisotropy = 96, kLabels = 40,
                 kFigures = 12 * 15 + 6;
constexpr double kCaption = 18, kLegend = 40;
constexpr double kCard = kTitle + kInner + kCaption + kInner + kGap + kRadial + kLabels + kAnisotropy +
                         kLabels + kFigures + 2 * kGap;

std::string shortened(const std::string& title) {
  constexpr std::size_t kMost = 30;
  return title.size() <= kMost ? title : "..." + title.substr(title.size() - kMost + 3);
}

/// The radial axes' common upper end: the highest mean of all, but no more than 4.
Axis power_axis(const std::vector<SheetEntry>& entries) {
  double most = 2;
  for (const SheetEntry& entry : entries) most = std::max(most, std::ceil(entry.radial.peak));
  Axis axis{0, std::min(most, 4.0), {}, "radial mean"};
  for (double tick = 0; tick <= axis.high; ++tick) axis.ticks.push_back(tick);
  return axis;
}

void draw_curves(Canvas& canvas, const SheetEntry& entry, const Axis& power, double x, double top) {
  const RadialSpectrum& radial = entry.radial;
  Axis frequency{0, 2.5, {0, 0.5, 1, 1.5, 2, 2.5}, "frequency / \u221an"};
  if (!radial.frequency.empty()) frequency.high = radial.frequency.back();
  std::vector<glm::dvec2> mean, anisotropy;
  for (std::size_t r = 0; r < radial.frequency.size(); ++r) {
    mean.emplace_back(radial.frequency[r], radial.mean[r]);
    anisotropy.emplace_back(radial.frequency[r], radial.anisotropy[r]);
  }
  if (frequency.high < 2.5 || frequency.high > 2.6)
    std::erase_if(frequency.ticks, [&](double t) { return t > frequency.high; });
  const Box upper{x, top, kInner, kRadial}, lower{x, top + kRadial + kLabels, kInner, kAnisotropy};
  const Level white[] = {{1, ""}};
  draw_curve(canvas, upper, frequency, power, white, mean, kBlue);
  const double noise = -10 * std::log10(static_cast<double>(entry.sets));
  const Level expected[] = {{noise, ""}};
  draw_curve(canvas, lower, frequency, {-20, 20, {-20, -10, 0, 10, 20}, "anisotropy, dB"}, expected,
             anisotropy, kRed);
}

void draw_entry(Canvas& canvas, const SheetEntry& entry, const Axis& power, glm::dvec2 at) {
  const double x = at.x + kIndent;
  double y = at.y;
  canvas.text({x, y + 13}, shortened(entry.title), {.colour = kInk, .size = 14, .bold = true});
  const std::string sets = entry.sets > 1 ? fmt::format(", means of {} sets", entry.sets) : "";
  canvas.text({x, y + 30}, fmt::format("n = {}{}", entry.points.size(), sets), {.colour = kSoft, .size = 11});
  y += kTitle;
  const double part = draw_cells(canvas, {x, y, kInner, kInner}, entry.points);
  y += kInner;
  if (part < 1)
    canvas.text({x, y + 13}, fmt::format("a part: {:.3g} of the side", part), {.colour = kSoft, .size = 10});
  y += kCaption;
  const Box square{x, y, kInner, kInner};
  if (entry.spectrum) {
    draw_spectrum(canvas, square, *entry.spectrum);
  } else {
    canvas.rectangle(square, kPanel);
    canvas.text({x + kInner / 2, y + kInner / 2}, "spectrum not computed (--all)",
                {.colour = kSoft, .size = 11, .anchor = Anchor::kMiddle});
  }
  y += kInner + kGap;
  draw_curves(canvas, entry, power, x, y);
  y += kRadial + kLabels + kAnisotropy + kLabels;
  draw_figures(canvas, {x, y, kInner, kFigures}, entry.measures, entry.spectrum ? &entry.radial : nullptr);
}

}  // namespace

MeasureSheet::MeasureSheet(std::vector<SheetEntry> entries, std::size_t columns)
    : entries_(std::move(entries)), columns_(columns) {
  if (columns_ == 0) {  // even rows
    const std::size_t rows = (entries_.size() + 5) / 6;
    columns_ = (entries_.size() + rows - 1) / std::max<std::size_t>(rows, 1);
  }
}

double MeasureSheet::width() const {
  return 2 * kMargin + double(columns_) * kColumn;
}

double MeasureSheet::height() const {
  return kMargin + double((entries_.size() + columns_ - 1) / columns_) * kCard +
         (columns_ < 3 ? 2.4 : 1) * kLegend;
}

void MeasureSheet::draw(Canvas& canvas) const {
  const Axis power = power_axis(entries_);
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    draw_entry(canvas, entries_[k], power,
               {kMargin - 12 + double(k % columns_) * kColumn, kMargin + double(k / columns_) * kCard});
  }
  const double legend = height() - (columns_ < 3 ? 2.4 : 1) * kLegend;
  draw_legend(canvas, {kMargin + kIndent - 12, legend}, columns_ < 3);
}

}  // namespace capcon::plot
