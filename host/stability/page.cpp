#include "stability/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/file.h"
#include "study/chart.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon::stability {
namespace {

std::string cell(std::uint64_t count) {
  return count == 0 ? "0" : grouped(count);
}

/// RMSE against samples, with 1 / sqrt(n) through the first point, dashed.
std::string chart_of(const std::string& group, const std::vector<Check>& checks) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  Chart chart;
  chart.id = "sums";
  chart.title = "RMSE against samples a pixel";
  chart.description = "Error of sums of up to 2^24 samples a pixel; dashed: 1 / sqrt(n).";
  chart.x_label = "samples a pixel";
  chart.y_label = "RMSE";
  for (const Check& c : checks) {
    if (c.group != group || c.curve.empty()) continue;
    ChartLine line;
    line.name = c.name;
    line.style = static_cast<int>(chart.lines.size());
    const auto point = [&](double x, double y) {
      return ChartPoint{{x, unknown, unknown}, {y, unknown, unknown}, true, {}};
    };
    for (const auto& [n, rmse] : c.curve) {
      line.points.push_back(point(n, rmse));
      line.companion.push_back(point(n, c.curve.front().second * std::sqrt(c.curve.front().first / n)));
    }
    chart.lines.push_back(line);
  }
  return chart.lines.empty() ? "" : "<figure>" + svg_chart(chart) + "</figure>";
}

std::string table_of(const std::string& group, const std::vector<Check>& checks) {
  HtmlTable table(group, {"check", "what is extreme", "values", "not finite", "largest", "beyond", "measured",
                          "bound", "why that bound", "s", "verdict"});
  for (const Check& c : checks) {
    if (c.group != group) continue;
    table.row({fmt::format("<code>{}</code>", escape(c.name)), escape(c.what), cell(c.values),
               cell(c.non_finite), std::isfinite(c.largest) ? scientific(c.largest) : "–", cell(c.beyond),
               escape(c.measured), escape(c.bound), escape(c.reason), fmt::format("{:.1f}", c.seconds),
               c.passed ? "ok" : "<strong>failed</strong>"});
  }
  return "<section>" + table.str() + chart_of(group, checks) + "</section>\n";
}

}  // namespace

std::string stability_page(const std::vector<Check>& checks, const std::string& command) {
  const auto passed = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
  std::string device;
  for (const Check& c : checks) device = device.empty() ? c.device : device;
  double seconds = 0;
  for (const Check& c : checks) seconds += c.seconds;
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><title>Numerical "
      "stability</title><style>{}\nmain{{max-width:86rem}}"
      "td,th{{text-align:left!important;vertical-align:top;white-space:normal!important}}figure{{max-width:"
      "38rem}}td{{font-size:.82rem}}</style></"
      "head><body><main>\n<h1>Numerical stability</h1>\n"
      "<p><strong>{} of {} checks passed</strong> in {}. Each image is rendered on the device in float and "
      "by the reference in "
      "double, with the same sample points. A pixel deviates by the largest difference of a channel, "
      "relative to the reference "
      "there or to the mean of its image, whichever is larger; <em>beyond</em> counts pixels above the "
      "bound's tolerance.</p>\n",
      report_style(), passed, checks.size(), duration(seconds));
  std::string group;
  for (const Check& c : checks) {
    if (c.group == group) continue;
    group = c.group;
    html += table_of(group, checks);
  }
  html += fmt::format(
      "<section><h2>What ran</h2><dl><dt>Device</dt><dd>{}</dd><dt>Version</dt><dd>capcon "
      "{}</dd><dt>Command</dt><dd><code>{}</code>"
      "</dd></dl></section>\n</main></body></html>\n",
      escape(device), version(), escape(command));
  return html;
}

}  // namespace capcon::stability
