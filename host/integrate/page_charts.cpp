#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "integrate/columns.h"
#include "integrate/report.h"
#include "study/chart.h"
#include "study/format.h"
#include "study/html.h"

namespace capcon::integrate {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
Interval exactly(double v) {
  return {v, kNone, kNone};
}

/// More lines than this are not told apart: then these are drawn, and the table has all.
constexpr std::size_t kMostLines = 12;
constexpr std::array kChosen = {"random",    "importance", "random-areas", "jittered",
                                "sobol-xor", "sobol-owen", "lattice",      "lloyd",
                                "fpo",       "ccvt",       "ccvt-areas",   "capcon"};
/// Smaller errors would squeeze all others together.
constexpr double kFloor = 1e-8;
/// Whose bounds are drawn: one of each kind.
constexpr std::array kBounded = {"random", "sobol-owen", "ccvt-areas"};

bool is_one_of(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string note_of(const std::string& name, std::uint32_t n, const Figure& figure, const Sample& sample,
                    const Cost& cost) {
  std::string note = fmt::format("{}, n = {}: RMSE {} {}, {}", name, n, scientific(figure.rmse.value),
                                 percent_around(figure.rmse), duration(whole_seconds(cost)));
  if (sample.bound.kind != Bound::Kind::none) note += fmt::format("; bound {}", bound_text(sample.bound));
  return note;
}

/// Both charts' lines of one estimator.
struct Lines {
  ChartLine by_count, by_time;
};

Lines lines_of(const Experiment& experiment, const Analysis& analysis, std::size_t i, std::size_t e) {
  const Settings& s = experiment.settings;
  const std::string& name = s.estimators[e];
  const bool strong = name == "ccvt" || name == "capcon";
  Lines lines{{name, style_of(name), strong, {}, {}}, {name, style_of(name), strong, {}, {}}};
  for (std::size_t c = 0; c < s.counts.size(); ++c) {
    const std::size_t at = experiment.index(i, e, c);
    const Figure& figure = analysis.figures[at];
    if (!figure.measured || figure.rmse.value < kFloor) continue;
    const Bound& bound = experiment.samples[at].bound;
    const std::string note = note_of(name, s.counts[c], figure, experiment.samples[at], experiment.costs[at]);
    lines.by_count.points.push_back({exactly(s.counts[c]), figure.rmse, true, note});
    lines.by_time.points.push_back({exactly(whole_seconds(experiment.costs[at])), figure.rmse, true, note});
    if (experiment.costs[at].preparation > 0) {
      lines.by_time.companion.push_back(
          {exactly(ready_seconds(experiment.costs[at])), figure.rmse, true, {}});
    }
    if (bound.kind != Bound::Kind::none && is_one_of(kBounded, name)) {
      lines.by_count.companion.push_back({exactly(s.counts[c]), exactly(bound.mean), true, {}});
    }
  }
  return lines;
}

std::string table_html(const Experiment& experiment, const Analysis& analysis, std::size_t i) {
  const Settings& s = experiment.settings;
  const std::vector<std::size_t> spoken = spoken_counts(s);
  const std::size_t last = spoken.back();
  std::vector<std::string> head = {"estimator"};
  for (const std::size_t c : spoken) head.push_back(fmt::format("RMSE, n = {}", s.counts[c]));
  for (const char* word : {"slope", "MSE / random's", "MSE / sobol-owen's", "bound", "held in", "CPU time"})
    head.emplace_back(word);
  HtmlTable table(fmt::format("Ratios, bounds and time at n = {}", s.counts[last]), head);
  for (std::size_t e = 0; e < s.estimators.size(); ++e) {
    const std::size_t at = experiment.index(i, e, last);
    const Figure& figure = analysis.figures[at];
    if (!figure.measured) continue;
    std::vector<std::string> row = {svg_marker(style_of(s.estimators[e])) + escape(s.estimators[e])};
    for (const std::size_t c : spoken) row.push_back(rmse_text(analysis.figures[experiment.index(i, e, c)]));
    row.push_back(slope_text(analysis.laws[i * s.estimators.size() + e].slope));
    row.push_back(ratio_text(figure.beside_random));
    row.push_back(ratio_text(figure.beside_owen));
    const Bound& bound = experiment.samples[at].bound;
    row.push_back(bound.kind == Bound::Kind::none
                      ? fmt::format("<span class=\"none\">{}</span>", escape(bound.missing))
                      : bound_text(bound));
    row.push_back(bound_held_text(bound));
    row.push_back(duration(whole_seconds(experiment.costs[at])));
    table.row(row);
  }
  return table.str();
}

}  // namespace

std::string integrand_section(const Experiment& experiment, const Analysis& analysis, std::size_t i) {
  const Settings& s = experiment.settings;
  const Integrand& integrand = find_integrand(s.integrands[i]);
  Chart by_count{"n-" + integrand.name,
                 "Error against points",
                 "Root mean squared error over n, a line an estimator.",
                 "points n",
                 "RMSE",
                 LogAxis::Style::counts,
                 LogAxis::Style::decades,
                 false,
                 {}};
  Chart by_time{"t-" + integrand.name,
                "Error against time",
                "Root mean squared error over processor seconds of one estimate.",
                "processor time of one estimate, points included",
                "RMSE",
                LogAxis::Style::seconds,
                LogAxis::Style::decades,
                false,
                {}};
  std::vector<std::string> bounds, left_out;
  for (std::size_t e = 0; e < s.estimators.size(); ++e) {
    const std::string& name = s.estimators[e];
    if (!analysis.figures[experiment.index(i, e, 0)].measured) continue;
    if (s.estimators.size() > kMostLines && !is_one_of(kChosen, name)) {
      left_out.push_back(name);
      continue;
    }
    const Lines lines = lines_of(experiment, analysis, i, e);
    by_count.lines.push_back(lines.by_count);
    by_time.lines.push_back(lines.by_time);
    if (!lines.by_count.companion.empty()) {
      bounds.push_back(fmt::format(
          "{} for {}", bound_name(experiment.samples[experiment.index(i, e, 0)].bound.kind), name));
    }
  }
  std::string caption = bounds.empty()
                            ? "No bound applies."
                            : fmt::format("Dashed, in the line's colour: the bound {}.", enumerate(bounds));
  caption += fmt::format(" Bars: 95 % intervals. Errors below {} are not drawn.", scientific(kFloor));
  if (!left_out.empty()) caption += fmt::format(" In the table only: {}.", enumerate(left_out));
  std::string html = fmt::format("<p>{}</p>", escape(integrand.formula));
  if (!integrand.importance)
    html +=
        fmt::format("<p class=\"small\">No importance sampling: {}.</p>", escape(integrand.no_importance));
  else
    html += fmt::format("<p class=\"small\">Importance sampling by the density {}.</p>",
                        escape(integrand.importance->density));
  html += "<div class=\"charts\">" + chart_figure(by_count, caption) +
          chart_figure(by_time,
                       "From nothing: making the points, weights, evaluation. Dashed: with the set that all "
                       "randomisations share at hand.") +
          "</div>";
  return html + "<details><summary>All figures</summary>" + table_html(experiment, analysis, i) +
         "</details>";
}

}  // namespace capcon::integrate
