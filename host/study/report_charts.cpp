#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "study/chart.h"
#include "study/findings.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon {
namespace {

using Place = std::function<Interval(const Cell&)>;

Interval exactly(double v) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {v, kNone, kNone};
}

std::vector<ChartPoint> points_of(const Curve& curve, const Place& x) {
  std::vector<ChartPoint> points;
  for (const Cell& cell : curve.cells) {
    if (cell.mse.value <= 0) continue;  // the reference cannot tell: nothing to draw
    points.push_back({x(cell), cell.mse, cell.sure,
                      fmt::format("{} at {}: MSE {} {}, {} on the device", curve.sampler, cell.samples,
                                  scientific(cell.mse.value), percent_around(cell.mse),
                                  duration(cell.device_seconds.value))});
  }
  return points;
}

ChartLine line_of(const Curve& curve, const StudySettings& settings, const Place& x) {
  return {curve.sampler,
          sampler_style(curve.sampler, settings),
          curve.sampler == study_subject(settings),
          points_of(curve, x),
          {}};
}

std::string error_chart(const StudyResult& result, const Figures& figures) {
  Chart chart{"c-samples",
              fmt::format("Error against {}", words_of(result.settings.integral).many),
              fmt::format("Mean squared error over {}, one line a sampler.",
                          words_of(result.settings.integral).counts),
              std::string(words_of(result.settings.integral).counts),
              "MSE",
              LogAxis::Style::counts,
              LogAxis::Style::decades,
              false,
              {}};
  for (const Curve& curve : figures.curves) {
    chart.lines.push_back(line_of(curve, result.settings, [](const Cell& c) { return exactly(c.samples); }));
  }
  return chart_figure(chart,
                      "Lower is better. Bars: 95 % intervals over the seeds, often smaller than the marker.");
}

std::string relative_chart(const StudyResult& result, const Figures& figures, const std::string& baseline) {
  constexpr double kTooFar = 4;  // a line that goes farther would flatten all others
  Chart chart{"c-relative",
              "The same, beside " + baseline,
              fmt::format("MSE divided by that of {} at equal {}.", baseline,
                          words_of(result.settings.integral).many),
              std::string(words_of(result.settings.integral).counts),
              "MSE / MSE of " + baseline,
              LogAxis::Style::counts,
              LogAxis::Style::plain,
              true,
              {}};
  std::string left_out;
  for (const Curve& curve : figures.curves) {
    ChartLine line{curve.sampler,
                   sampler_style(curve.sampler, result.settings),
                   curve.sampler == study_subject(result.settings),
                   {},
                   {}};
    double farthest = 0;
    for (const Cell& cell : curve.cells) {
      const Ratio* r = figures.ratio(curve.sampler, baseline, cell.samples);
      if (!r || std::isnan(r->mse.value)) continue;
      farthest = std::max(farthest, r->mse.value);
      line.points.push_back({exactly(cell.samples), r->mse, true,
                             fmt::format("{} at {}: {} times the MSE of {}", curve.sampler, cell.samples,
                                         with_range(r->mse), baseline)});
    }
    if (farthest > kTooFar && !line.strong) {
      left_out +=
          fmt::format(" Left out: {}, up to {} times.", escape(curve.sampler), short_number(farthest));
    } else {
      chart.lines.push_back(line);
    }
  }
  return chart_figure(
      chart, fmt::format("Below the heavy line a sampler errs less than {} with as many {}.{}", baseline,
                         words_of(result.settings.integral).many, left_out));
}

std::string device_chart(const StudyResult& result, const Figures& figures) {
  Chart chart{"c-device",
              "Error against device time",
              "Mean squared error over device seconds, one line a sampler.",
              "device time of a render",
              "MSE",
              LogAxis::Style::seconds,
              LogAxis::Style::decades,
              false,
              {}};
  for (const Curve& curve : figures.curves) {
    chart.lines.push_back(line_of(curve, result.settings, [](const Cell& c) { return c.device_seconds; }));
  }
  return chart_figure(
      chart,
      "Sum of the device's own timestamps over all stages of a render; bars across: its 95 % interval.");
}

std::string wall_chart(const StudyResult& result, const Figures& figures) {
  Chart chart{"c-wall",
              "Error against whole time",
              "Mean squared error over seconds on the clock, one line a sampler.",
              "whole time of a render",
              "MSE",
              LogAxis::Style::seconds,
              LogAxis::Style::decades,
              false,
              {}};
  for (const Curve& curve : figures.curves) {
    ChartLine line = line_of(curve, result.settings, [](const Cell& c) { return c.wall_seconds; });
    line.companion = points_of(curve, [](const Cell& c) { return c.wall_without_points; });
    chart.lines.push_back(line);
  }
  return chart_figure(
      chart,
      "Seconds on the clock from job to image, with making the points; dashed: without making the points.");
}

}  // namespace

std::string report_charts(const StudyResult& result, const Figures& figures) {
  std::string html = "<div class=\"charts\">" + error_chart(result, figures);
  if (!figures.baselines.empty()) html += relative_chart(result, figures, figures.baselines.back());
  if (result.settings.integral == Integral::splitting)
    return html + "</div>";  // all splits take about the same time
  return html + device_chart(result, figures) + wall_chart(result, figures) + "</div>";
}

}  // namespace capcon
