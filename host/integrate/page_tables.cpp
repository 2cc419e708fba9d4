#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrate/columns.h"
#include "integrate/report.h"
#include "study/chart.h"
#include "study/format.h"
#include "study/html.h"

namespace capcon::integrate {

std::string ratio_table(const Experiment& experiment, const Analysis& analysis, std::size_t count) {
  const Settings& s = experiment.settings;
  std::vector<std::string> head = {"estimator"};
  std::vector<double> lowest(s.integrands.size(), INFINITY);
  for (std::size_t i = 0; i < s.integrands.size(); ++i) {
    head.push_back(escape(s.integrands[i]));
    for (std::size_t e = 0; e < s.estimators.size(); ++e) {
      const double v = analysis.figures[experiment.index(i, e, count)].beside_random.value;
      if (analysis.figures[experiment.index(i, e, count)].exact) lowest[i] = 0;
      if (v > 0) lowest[i] = std::min(lowest[i], v);
    }
  }
  HtmlTable table(fmt::format("n = {}: MSE / MSE of random points", s.counts[count]), head);
  for (std::size_t e = 0; e < s.estimators.size(); ++e) {
    if (s.estimators[e] == "random") continue;  // 1 everywhere
    std::vector<std::string> row = {svg_marker(style_of(s.estimators[e])) + escape(s.estimators[e])};
    for (std::size_t i = 0; i < s.integrands.size(); ++i) {
      const Figure& figure = analysis.figures[experiment.index(i, e, count)];
      const Interval& r = figure.beside_random;
      if (std::isnan(r.value)) {
        row.push_back(fmt::format("<span class=\"{}\">{}</span>", figure.exact ? "best" : "none",
                                  figure.exact ? "exact" : "–"));
        continue;
      }
      row.push_back(fmt::format("<span class=\"figure{}\">{}</span><span class=\"interval\">{}</span>",
                                r.value == lowest[i] ? " best" : "",
                                r.value < 0.0095 ? scientific(r.value) : short_number(r.value),
                                percent_around(r)));
    }
    table.row(row);
  }
  return table.str();
}

std::string energy_section(const std::vector<GeneratorEnergy>& plane) {
  constexpr double kLeast = 1e-3;  // 0 has no place on a logarithmic axis
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Chart chart{"energy",
              fmt::format("Energy against areas, n = {}", kPlanePoints),
              "Excess energy over the standard deviation of the areas, a mark a generator.",
              "standard deviation of n · area",
              "energy − 1 (0 = hexagons)",
              LogAxis::Style::decades,
              LogAxis::Style::decades,
              false,
              {}};
  HtmlTable table(fmt::format("Ordinary Voronoi cells on the torus, n = {}", kPlanePoints),
                  {"points", "energy", "area s.d.", "sets"});
  for (const GeneratorEnergy& g : plane) {
    const bool drawn = g.area_sd >= kLeast && g.energy - 1 >= kLeast / 10;
    chart.lines.push_back(
        {g.method,
         style_of(g.method),
         g.method == "ccvt" || g.method == "capcon",
         {{{std::max(g.area_sd, kLeast), kNone, kNone},
           {std::max(g.energy - 1, kLeast / 10), kNone, kNone},
           drawn,
           fmt::format("{}: energy {:.4f}, area s.d. {:.4f}", g.method, g.energy, g.area_sd)}},
         {}});
    table.row({svg_marker(style_of(g.method)) + escape(g.method), fmt::format("{:.4f}", g.energy),
               fmt::format("{:.4f}", g.area_sd), fmt::format("{}", g.sets)});
  }
  return fmt::format(
      "<p>The text asks whether points can have the least energy E and equal Voronoi regions at once. Energy "
      "is nE over that of hexagons, "
      "the least there is; the areas are those of the ordinary cells. Both are best at the lower left.</p>"
      "<div class=\"charts\"><figure><h3>{}</h3>{}<figcaption>Hollow: smaller than the axis can show, drawn "
      "at its end.</figcaption></figure>"
      "<div>{}</div></div>",
      chart.title, svg_chart(chart), table.str());
}

}  // namespace capcon::integrate
