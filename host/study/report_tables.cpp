#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/chart.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"
#include "study/report_csv.h"

namespace capcon {
namespace {

const std::string kNone = "<span class=\"none\">–</span>";

std::string sampler_name(const std::string& sampler, const StudySettings& settings) {
  return svg_marker(sampler_style(sampler, settings)) + escape(sampler);
}

std::vector<std::string> head(const std::string& first, const StudyResult& result,
                              const std::string& without = {}) {
  std::vector<std::string> cells = {first};
  for (const std::string& sampler : result.settings.samplers) {
    if (sampler != without) cells.push_back(sampler_name(sampler, result.settings));
  }
  return cells;
}

/// A figure with its interval below it in small print.
std::string cell(const std::string& value, const std::string& small, const std::string& mark = {}) {
  return fmt::format("<span class=\"figure {}\">{}</span><span class=\"interval\">{}</span>", mark, value,
                     small);
}

/// Marked where the interval shows that the sampler is better or worse than its baseline.
std::string ratio_cell(const Interval& v, double even) {
  if (std::isnan(v.value)) return kNone;
  return cell(short_number(v.value), range(v), v.below(even) ? "better" : v.above(even) ? "worse" : "");
}

/// Another measure of the error, cell by cell: nothing is taken off, so that none is unsure.
std::string measure_table(const StudyResult& result, const Figures& figures, const std::string& caption,
                          Interval Cell::*measure, bool factor) {
  HtmlTable table(caption, head(std::string(words_of(result.settings.integral).many), result));
  for (const std::uint32_t n : result.settings.samples) {
    double lowest = INFINITY;
    for (const Curve& curve : figures.curves) {
      const Cell* c = find_cell(curve, n);
      if (c && std::isfinite((c->*measure).value)) lowest = std::min(lowest, (c->*measure).value);
    }
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      const Cell* c = find_cell(curve, n);
      if (!c || !std::isfinite((c->*measure).value)) {
        row.push_back(kNone);
        continue;
      }
      const Interval& v = c->*measure;
      const std::string around = factor ? percent_around(v)
                                 : std::isnan(v.low)
                                     ? ""
                                     : fmt::format("±{:.1f} %", 50 * (v.high - v.low) / v.value);
      row.push_back(cell(factor ? scientific(v.value) : fmt::format("{:.4f}", v.value), around,
                         v.value == lowest ? "best" : ""));
    }
    table.row(row);
  }
  table.csv(cells_csv(figures), "figures.csv");
  return table.str();
}

/// relMSE and FLIP beside the MSE.
std::string other_measures(const StudyResult& result, const Figures& figures) {
  std::string html =
      "<div class=\"pair\">" +
      measure_table(result, figures,
                    "relMSE: mean of (I − R̄)² / (R̄² + 0.01), with 95 % interval; the reference’s "
                    "own error is in it",
                    &Cell::relmse, true);
  const bool measured = std::any_of(figures.curves.begin(), figures.curves.end(), [](const Curve& curve) {
    return std::any_of(curve.cells.begin(), curve.cells.end(),
                       [](const Cell& c) { return std::isfinite(c.flip.value); });
  });
  if (measured) {
    html +=
        measure_table(result, figures,
                      "FLIP: how different image and reference look at exposure 1, 0 to 1, mean over pixels "
                      "and seeds with 95 % interval",
                      &Cell::flip, false);
  }
  return html + "</div>";
}

std::string mse_table(const StudyResult& result, const Figures& figures) {
  HtmlTable table("Mean squared error, with 95 % interval; the lowest of each row underlined",
                  head(std::string(words_of(result.settings.integral).many), result));
  for (const std::uint32_t n : result.settings.samples) {
    double lowest = INFINITY;
    for (const Curve& curve : figures.curves) {
      const Cell* c = find_cell(curve, n);
      if (c && c->sure) lowest = std::min(lowest, c->mse.value);
    }
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      const Cell* c = find_cell(curve, n);
      row.push_back(!c         ? kNone
                    : !c->sure ? cell("unsure", "below the reference's margin")
                               : cell(scientific(c->mse.value), percent_around(c->mse),
                                      c->mse.value == lowest ? "best" : ""));
    }
    table.row(row);
  }
  table.csv(cells_csv(figures), "figures.csv");
  return table.str();
}

std::string slope_table(const StudyResult& result, const Figures& figures) {
  HtmlTable table(
      fmt::format("Slopes in log-log, from {} {} on (random points: -1 over {})", kSlopeFrom,
                  words_of(result.settings.integral).many, words_of(result.settings.integral).many),
      head("over", result));
  const auto slope_row = [&](const std::string& name, Interval Curve::*slope) {
    std::vector<std::string> row = {name};
    for (const Curve& curve : figures.curves) {
      const Interval& v = curve.*slope;
      row.push_back(std::isnan(v.value)
                        ? kNone
                        : cell(fmt::format("{:.3f}", v.value),
                               std::isnan(v.low) ? "" : fmt::format("{:.3f} … {:.3f}", v.low, v.high)));
    }
    table.row(row);
  };
  slope_row(std::string(words_of(result.settings.integral).many), &Curve::slope);
  slope_row("device time", &Curve::time_slope);
  Csv csv("sampler,over,slope,slope_low,slope_high");
  for (const Curve& curve : figures.curves) {
    csv.add(curve.sampler).add(words_of(result.settings.integral).many).add(curve.slope).end_row();
    csv.add(curve.sampler).add("device time").add(curve.time_slope).end_row();
  }
  table.csv(csv, "slopes.csv");
  return table.str();
}

std::string time_table(const StudyResult& result, const Figures& figures) {
  HtmlTable table("Device time of a render; below it the time to make the points",
                  head(std::string(words_of(result.settings.integral).many), result));
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      const Cell* c = find_cell(curve, n);
      row.push_back(!c ? kNone
                       : cell(duration(c->device_seconds.value), "points " + duration(c->point_seconds)));
    }
    table.row(row);
  }
  table.csv(cells_csv(figures), "figures.csv");
  return table.str();
}

/// MSE beside a baseline's at equal counts.
std::string ratio_table(const StudyResult& result, const Figures& figures, const std::string& baseline) {
  const std::string_view many = words_of(result.settings.integral).many;
  HtmlTable table(fmt::format("MSE / MSE of {} at as many {}", baseline, many),
                  head(std::string(many), result, baseline));
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      if (curve.sampler == baseline) continue;
      const Ratio* r = figures.ratio(curve.sampler, baseline, n);
      row.push_back(r ? ratio_cell(r->mse, 1) : kNone);
    }
    table.row(row);
  }
  table.csv(ratios_csv(figures, baseline), "ratios-" + baseline + ".csv");
  return table.str();
}

std::string equal_error_table(const StudyResult& result, const Figures& figures,
                              const std::string& baseline) {
  HtmlTable table(fmt::format("Equal error: {0} needed to be as good as {1} at n {0}",
                              words_of(result.settings.integral).many, baseline),
                  head("n", result, baseline));
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      if (curve.sampler == baseline) continue;
      const Ratio* r = figures.ratio(curve.sampler, baseline, n);
      row.push_back(
          !r              ? kNone
          : r->beyond < 0 ? cell(fmt::format("&lt; {}", result.settings.samples.front()), "out of range")
          : r->beyond > 0 ? cell(fmt::format("&gt; {}", result.settings.samples.back()), "out of range")
                          : ratio_cell(r->equal_error, n));
    }
    table.row(row);
  }
  table.csv(ratios_csv(figures, baseline), "ratios-" + baseline + ".csv");
  return table.str();
}

std::string equal_time_table(const StudyResult& result, const Figures& figures, const std::string& baseline) {
  HtmlTable table(fmt::format("Equal time: MSE beside that of {}, in the device time its n {} take", baseline,
                              words_of(result.settings.integral).many),
                  head("n", result, baseline));
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      if (curve.sampler == baseline) continue;
      const Ratio* r = figures.ratio(curve.sampler, baseline, n);
      row.push_back(r ? ratio_cell(r->equal_time, 1) : kNone);
    }
    table.row(row);
  }
  table.csv(ratios_csv(figures, baseline), "ratios-" + baseline + ".csv");
  return table.str();
}

}  // namespace

std::string report_tables(const StudyResult& result, const Figures& figures) {
  if (result.settings.integral == Integral::splitting)
    return mse_table(result, figures) + other_measures(result, figures) + time_table(result, figures);
  std::string html =
      mse_table(result, figures) + other_measures(result, figures) + slope_table(result, figures) +
      "<p class=\"small\"><span class=\"better\">▼ better</span> and <span class=\"worse\">▲ worse</span> "
      "than the "
      "baseline mark differences that the interval shows; figures without a mark may be even.</p>";
  if (result.settings.integral == Integral::global_illumination) {
    html += "<div class=\"pair\">";
    for (const std::string& baseline : figures.baselines) html += ratio_table(result, figures, baseline);
    html += "</div>";
  }
  for (const std::string& baseline : figures.baselines) {
    html += "<div class=\"pair\">" + equal_error_table(result, figures, baseline) +
            equal_time_table(result, figures, baseline) + "</div>";
  }
  return html + time_table(result, figures);
}

}  // namespace capcon
