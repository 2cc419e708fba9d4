#include <cmath>
#include <nlohmann/json.hpp>

#include "study/clocks.h"
#include "study/coarse.h"
#include "study/figures.h"
#include "study/findings.h"

namespace capcon {
using nlohmann::json;

namespace {

json number(double v) {
  return std::isfinite(v) ? json(v) : json(nullptr);
}

json interval(const Interval& v) {
  return {{"value", number(v.value)}, {"low", number(v.low)}, {"high", number(v.high)}};
}

json noise_json(const Noise& noise) {
  json cells = json::array();
  for (const NoiseCell& c : noise.cells) {
    cells.push_back({{"sampler", c.sampler},
                     {"samples", c.samples},
                     {"deviation", interval(c.deviation)},
                     {"mean_error", number(c.mean_error)},
                     {"mean_error_by_chance", number(c.chance)},
                     {"bias_square", interval(c.bias_square)},
                     {"coarse_share", interval(c.coarse)}});
  }
  return {
      {"coarse_block", kCoarseBlock}, {"coarse_share_by_chance", noise.coarse_by_chance}, {"cells", cells}};
}

json cell_json(const Cell& c) {
  return {{"samples", c.samples},
          {"mse", interval(c.mse)},
          {"mean_mse", number(c.mean_mse)},
          {"relmse", interval(c.relmse)},
          {"flip", interval(c.flip)},
          {"sure", c.sure},
          {"device_seconds", interval(c.device_seconds)},
          {"wall_seconds", interval(c.wall_seconds)},
          {"wall_seconds_without_points", interval(c.wall_without_points)},
          {"point_generation_seconds", number(c.point_seconds)}};
}

}  // namespace

json to_json(const StudyResult& result, const Figures& figures) {
  json curves = json::array();
  for (const Curve& curve : figures.curves) {
    json cells = json::array();
    for (const Cell& cell : curve.cells) cells.push_back(cell_json(cell));
    curves.push_back({{"sampler", curve.sampler},
                      {"slope", interval(curve.slope)},
                      {"time_slope", interval(curve.time_slope)},
                      {"slope_cells", curve.slope_cells},
                      {"cells", cells}});
  }
  json ratios = json::array();
  for (const Ratio& r : figures.ratios) {
    ratios.push_back({{"sampler", r.sampler},
                      {"baseline", r.baseline},
                      {"samples", r.samples},
                      {"mse_ratio", interval(r.mse)},
                      {"equal_error_samples", interval(r.equal_error)},
                      {"equal_error_beyond", r.beyond},
                      {"equal_error_time_ratio", interval(r.equal_error_time)},
                      {"equal_time_mse_ratio", interval(r.equal_time)}});
  }
  json whole = {{"study", words_of(result.settings.integral).slug},
                {"version", result.version},
                {"started", result.started},
                {"settings", to_json(result.settings)},
                {"device", result.device},
                {"findings", make_findings(result.settings, figures)},
                {"reference",
                 {{"error", figures.reference_error},
                  {"groups", result.settings.reference_groups},
                  {"coarse_error", result.reference.coarse_error},
                  {"samples", result.settings.reference_samples},
                  {"sampler", kReferenceSampler},
                  {"margin", kReferenceMargin}}},
                {"curves", curves},
                {"ratios", ratios}};
  if (figures.recommendation) whole["recommendation"] = to_json(*figures.recommendation);
  if (const Clocks clocks(result); clocks.several()) whole["clocks"] = to_json(clocks);
  if (!figures.noise.cells.empty()) whole["noise"] = noise_json(figures.noise);
  return whole;
}

}  // namespace capcon
