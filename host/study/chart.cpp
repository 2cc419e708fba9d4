#include "study/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/html.h"

namespace capcon {
namespace {

constexpr double kWidth = 560;
constexpr double kHeight = 420;
constexpr double kLeft = 64;
constexpr double kTop = 14;
constexpr double kBottom = kHeight - 50;
constexpr double kNameHeight = 15;

constexpr int kMarkers = 6;

/// Names stand to the right of it.
double right_of(const Chart& chart) {
  return kWidth - chart.name_room;
}

std::string marker(int style, double x, double y, double r, const std::string& attributes) {
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> corners) {
    std::string points;
    for (const auto& [u, v] : corners) points += fmt::format("{:.1f},{:.1f} ", x + r * u, y + r * v);
    points.pop_back();
    return fmt::format("<polygon points=\"{}\" {}/>", points, attributes);
  };
  switch (style % kMarkers) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>", x, y, r, attributes);
    case 1:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon({{0, -1.2}, {1.15, 0.9}, {-1.15, 0.9}});
    case 3:
      return polygon({{0, -1.35}, {1.15, 0}, {0, 1.35}, {-1.15, 0}});
    case 4:
      return polygon({{0, 1.2}, {1.15, -0.9}, {-1.15, -0.9}});
    default:
      return polygon({{-0.4, -1.2},
                      {0.4, -1.2},
                      {0.4, -0.4},
                      {1.2, -0.4},
                      {1.2, 0.4},
                      {0.4, 0.4},
                      {0.4, 1.2},
                      {-0.4, 1.2},
                      {-0.4, 0.4},
                      {-1.2, 0.4},
                      {-1.2, -0.4},
                      {-0.4, -0.4}});
  }
}

/// Smallest and largest of all that is drawn.
struct Extent {
  double low = INFINITY, high = 0;
  void add(double v) {
    if (!std::isfinite(v) || v <= 0) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  /// The ends of intervals, which may be so far apart (two seeds) that nothing else could be told apart
  /// beside them: they widen what is drawn by a factor of four at most, and are cut off there.
  void add_ends(const Extent& ends) {
    constexpr double kMost = 4;
    const double least = low / kMost, most = high * kMost;
    add(std::max(ends.low, least));
    add(std::min(ends.high, most));
  }
};

std::string grid(const Chart& chart, const LogAxis& x, const LogAxis& y) {
  std::string svg;
  for (const auto& tick : x.ticks()) {
    const double at = x.place(tick.value);
    svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                       tick.label.empty() ? "minor" : "major", at, at, kTop, kBottom);
    if (!tick.label.empty()) {
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", at, kBottom + 17,
                         tick.label);
    }
  }
  for (const auto& tick : y.ticks()) {
    const double at = y.place(tick.value);
    svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                       tick.label.empty() ? "minor" : "major", kLeft, right_of(chart), at, at);
    if (!tick.label.empty()) {
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", kLeft - 7, at + 4,
                         tick.label);
    }
  }
  if (chart.line_at_one && y.low() < 1 && y.high() > 1) {
    svg += fmt::format("<line class=\"one\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>", kLeft,
                       right_of(chart), y.place(1), y.place(1));
  }
  svg += fmt::format("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
                     (kLeft + right_of(chart)) / 2, kBottom + 40, escape(chart.x_label));
  svg += fmt::format(
      "<text class=\"axis\" transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
      (kTop + kBottom) / 2, escape(chart.y_label));
  return svg;
}

std::string path(const std::vector<ChartPoint>& points, const LogAxis& x, const LogAxis& y,
                 const char* attributes) {
  std::string data;
  for (const ChartPoint& p : points) {
    data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? "M" : "L", x.place(p.x.value), y.place(p.y.value));
  }
  return data.empty() ? "" : fmt::format("<path d=\"{}\" {}/>", data, attributes);
}

/// Where an end of an interval lies, cut off where the axis ends.
double inside(const LogAxis& axis, double v) {
  return axis.place(std::clamp(v, axis.low(), axis.high()));
}

std::string line_svg(const ChartLine& line, const LogAxis& x, const LogAxis& y) {
  std::string svg =
      fmt::format("<g class=\"s{} d{}{}\">", line.style, line.dash, line.strong ? " strong" : "");
  svg += path(line.companion, x, y, "class=\"line companion\"");
  svg += path(line.points, x, y, "class=\"line\"");
  for (const ChartPoint& p : line.points) {
    const double at_x = x.place(p.x.value);
    if (std::isfinite(p.y.low) && p.y.low > 0) {
      svg += fmt::format("<line class=\"bar\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>",
                         at_x, inside(y, p.y.low), inside(y, p.y.high));
    }
    if (std::isfinite(p.x.low) && p.x.low > 0) {
      svg += fmt::format("<line class=\"bar\" x1=\"{1:.1f}\" x2=\"{2:.1f}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>",
                         y.place(p.y.value), inside(x, p.x.low), inside(x, p.x.high));
    }
    svg += fmt::format(
        "<g>{}<title>{}</title></g>",
        marker(line.style, at_x, y.place(p.y.value), 3.6, p.sure ? "class=\"mark\"" : "class=\"hollow\""),
        escape(p.note));
  }
  return svg + "</g>";
}

/// The names at the right, pushed apart, each tied to its line's last point.
std::string names(const Chart& chart, const LogAxis& x, const LogAxis& y) {
  struct Name {
    const ChartLine* line;
    double x, y, at;
  };
  std::vector<Name> all;
  for (const ChartLine& line : chart.lines) {
    if (line.points.empty()) continue;
    const double end = y.place(line.points.back().y.value);
    all.push_back({&line, x.place(line.points.back().x.value), end, end});
  }
  std::sort(all.begin(), all.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < all.size(); ++i) all[i].at = std::max(all[i].at, all[i - 1].at + kNameHeight);
  double floor = kBottom + 4;  // from below, where the first pass ran out of the chart
  for (std::size_t i = all.size(); i-- > 0; floor = all[i].at - kNameHeight)
    all[i].at = std::min(all[i].at, floor);
  std::string svg;
  for (const Name& name : all) {
    svg += fmt::format(
        "<g class=\"s{}{}\"><path class=\"tie\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}\"/>"
        "<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>",
        name.line->style, name.line->strong ? " strong" : "", name.x + 6, name.y, right_of(chart) + 2,
        name.at, right_of(chart) + 8, name.at, right_of(chart) + 11, name.at + 4, escape(name.line->name));
  }
  return svg;
}

}  // namespace

std::string svg_chart(const Chart& chart) {
  Extent xs, ys, x_ends, y_ends;
  for (const ChartLine& line : chart.lines) {
    for (const auto* points : {&line.points, &line.companion}) {
      for (const ChartPoint& p : *points) {
        xs.add(p.x.value);
        ys.add(p.y.value);
        for (const double v : {p.x.low, p.x.high}) x_ends.add(v);
        for (const double v : {p.y.low, p.y.high}) y_ends.add(v);
      }
    }
  }
  if (chart.line_at_one) ys.add(1);
  if (x_ends.high > 0) xs.add_ends(x_ends);
  if (y_ends.high > 0) ys.add_ends(y_ends);
  if (xs.high <= 0 || ys.high <= 0) return "<p>There is nothing to draw.</p>";
  const LogAxis x(xs.low, xs.high, kLeft, right_of(chart), chart.x_style);
  const LogAxis y(ys.low, ys.high, kBottom, kTop, chart.y_style);
  std::string svg = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-labelledby=\"{}-t {}-d\">"
      "<title id=\"{}-t\">{}</title><desc id=\"{}-d\">{}</desc>",
      kWidth, kHeight, chart.id, chart.id, chart.id, escape(chart.title), chart.id,
      escape(chart.description));
  svg += grid(chart, x, y);
  for (const bool strong : {false, true}) {  // the line the study is about lies on top
    for (const ChartLine& line : chart.lines) {
      if (line.strong == strong) svg += line_svg(line, x, y);
    }
  }
  return svg + names(chart, x, y) + "</svg>";
}

std::string svg_marker(int style) {
  return fmt::format("<svg class=\"key s{}\" viewBox=\"0 0 14 14\" aria-hidden=\"true\">{}</svg>", style,
                     marker(style, 7, 7, 4.6, "class=\"mark\""));
}

}  // namespace capcon
