#include <cmath>

#include "base/file.h"
#include "integrate/columns.h"
#include "integrate/report.h"

namespace capcon::integrate {
namespace {

using Json = nlohmann::ordered_json;

Json number(double v) {
  return std::isfinite(v) ? Json(v) : Json(nullptr);
}
Json interval(const Interval& v) {
  return {{"value", number(v.value)}, {"low", number(v.low)}, {"high", number(v.high)}};
}

Json bound_json(const Bound& bound) {
  if (bound.kind == Bound::Kind::none) return {{"kind", nullptr}, {"why", bound.missing}};
  Json json = {{"kind", bound_name(bound.kind)},
               {"mean", bound.mean},
               {"checked", bound.checked},
               {"exceeded", bound.exceeded}};
  if (bound.kind == Bound::Kind::second_derivative) json["energy_part"] = bound.energy_part;
  return json;
}

Json row_json(const Experiment& experiment, const Analysis& analysis, std::size_t at, std::uint32_t n) {
  const Figure& figure = analysis.figures[at];
  const Cost& cost = experiment.costs[at];
  return {{"n", n},
          {"rmse", interval(figure.rmse)},
          {"mse_beside_random", interval(figure.beside_random)},
          {"mse_beside_sobol_owen", interval(figure.beside_owen)},
          {"bias_z", figure.bias_z},
          {"bound", bound_json(experiment.samples[at].bound)},
          {"cpu_seconds",
           {{"preparation", cost.preparation},
            {"points", cost.points},
            {"weights", cost.weights},
            {"evaluation", cost.evaluation}}}};
}

}  // namespace

Json to_json(const Experiment& experiment, const Analysis& analysis,
             const std::vector<GeneratorEnergy>& plane) {
  const Settings& s = experiment.settings;
  Json json = {{"program", "capcon " + std::string(version())},
               {"n", s.counts},
               {"randomisations", s.randomisations},
               {"seed", s.seed},
               {"slope_from", kSlopeFrom},
               {"seconds", experiment.seconds}};
  for (std::size_t i = 0; i < s.integrands.size(); ++i) {
    const Integrand& integrand = find_integrand(s.integrands[i]);
    Json entry = {
        {"integrand", integrand.name}, {"formula", integrand.formula}, {"family", integrand.family}};
    for (std::size_t e = 0; e < s.estimators.size(); ++e) {
      Json rows = Json::array();
      for (std::size_t c = 0; c < s.counts.size(); ++c) {
        const std::size_t at = experiment.index(i, e, c);
        if (analysis.figures[at].measured) rows.push_back(row_json(experiment, analysis, at, s.counts[c]));
      }
      Json estimator = {{"estimator", s.estimators[e]}};
      if (rows.empty()) {
        estimator["left_out"] = integrand.no_importance;
      } else {
        estimator["slope"] = interval(analysis.laws[i * s.estimators.size() + e].slope);
        estimator["rows"] = std::move(rows);
      }
      entry["estimators"].push_back(std::move(estimator));
    }
    json["integrands"].push_back(std::move(entry));
  }
  for (const GeneratorEnergy& g : plane) {
    json["energy_plane"].push_back({{"method", g.method},
                                    {"n", kPlanePoints},
                                    {"sets", g.sets},
                                    {"energy", g.energy},
                                    {"area_sd", g.area_sd}});
  }
  return json;
}

}  // namespace capcon::integrate
