#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/chart.h"
#include "study/html.h"

namespace capcon {
namespace {

using nlohmann::json;

/// Seven digits are enough for a chart.
json number(double v) {
  if (!std::isfinite(v)) return nullptr;
  return std::stod(fmt::format("{:.7g}", v));
}

const char* name_of(LogAxis::Style style) {
  switch (style) {
    case LogAxis::Style::decades:
      return "decades";
    case LogAxis::Style::counts:
      return "counts";
    case LogAxis::Style::seconds:
      return "seconds";
    case LogAxis::Style::plain:
      break;
  }
  return "plain";
}

/// How a line looks, where several kinds of lines have one colour.
std::string swatch(const ChartLine& line) {
  return fmt::format(
      "<svg class=\"swatch chart s{} d{}\" viewBox=\"0 0 30 14\" aria-hidden=\"true\"><path class=\"line\" "
      "d=\"M0 7L30 7\"/>"
      "</svg>",
      line.style, line.dash);
}

/// What page/charts.js reads.
json data_of(const Chart& chart) {
  const bool kinds =
      std::any_of(chart.lines.begin(), chart.lines.end(), [](const auto& l) { return l.dash > 0; });
  json lines = json::array();
  for (const ChartLine& line : chart.lines) {
    json points = json::array(), companion = json::array();
    for (const ChartPoint& p : line.points) {
      points.push_back({number(p.x.value), number(p.x.low), number(p.x.high), number(p.y.value),
                        number(p.y.low), number(p.y.high), p.sure, p.note});
    }
    for (const ChartPoint& p : line.companion) companion.push_back({number(p.x.value), number(p.y.value)});
    lines.push_back({{"name", line.name},
                     {"style", line.style},
                     {"dash", line.dash},
                     {"strong", line.strong},
                     {"key", kinds ? swatch(line) : svg_marker(line.style)},
                     {"points", points}});
    if (!companion.empty()) lines.back()["companion"] = companion;
  }
  return {{"title", chart.title},
          {"description", chart.description},
          {"x", {{"label", chart.x_label}, {"style", name_of(chart.x_style)}}},
          {"y", {{"label", chart.y_label}, {"style", name_of(chart.y_style)}}},
          {"one", chart.line_at_one},
          {"lines", lines}};
}

}  // namespace

std::string chart_figure(const Chart& chart, const std::string& caption) {
  return fmt::format(
      "<figure class=\"plot\" id=\"{}\"><h3>{}</h3><div "
      "class=\"still\">{}</div>{}<figcaption>{}</figcaption></figure>\n",
      chart.id, escape(chart.title), svg_chart(chart),
      data_script("type=\"application/json\"", data_of(chart).dump()), caption);
}

}  // namespace capcon
