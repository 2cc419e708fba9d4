#include "study/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "study/clocks.h"
#include "study/columns.h"
#include "study/recommendation.h"

namespace capcon {
namespace {

using columns::Kept;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Interval relmse_of(const Column& c) {
  const bool positive = std::all_of(c.relmse.begin(), c.relmse.end(), [](double v) { return v > 0; });
  return positive ? geometric_mean_interval(c.relmse) : Interval{mean(c.relmse), kUnknown, kUnknown};
}

Curve curve_of(const std::string& sampler, const std::vector<Column>& cells) {
  Curve curve{sampler, {}, {kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}, 0};
  std::size_t seeds = std::numeric_limits<std::size_t>::max();
  for (const Column& c : cells) {
    seeds = std::min(seeds, c.mse.size());
    Cell cell{c.samples,
              {mean(c.mse), kUnknown, kUnknown},
              relmse_of(c),
              c.flip.empty() ? Interval{kUnknown, kUnknown, kUnknown} : mean_interval(c.flip),
              mean(c.mse),
              geometric_mean_interval(c.device),
              geometric_mean_interval(c.wall),
              geometric_mean_interval(c.without_points),
              mean(c.points),
              c.sure};
    if (c.sure) cell.mse = geometric_mean_interval(c.mse);
    curve.slope_cells += c.sure && c.samples >= kSlopeFrom ? 1 : 0;
    curve.cells.push_back(cell);
  }
  if (curve.slope_cells >= 2) {
    curve.slope = jackknife(seeds, [&](Kept kept) {
      const columns::Path path = columns::path(cells, kept, kSlopeFrom);
      return log_log_slope(path.samples, path.mse);
    });
    curve.time_slope = jackknife(seeds, [&](Kept kept) {
      const columns::Path path = columns::path(cells, kept, kSlopeFrom);
      return log_log_slope(path.device, path.mse);
    });
  }
  return curve;
}

}  // namespace

const Curve* Figures::curve(const std::string& sampler) const {
  const auto found =
      std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.sampler == sampler; });
  return found == curves.end() ? nullptr : &*found;
}

const Ratio* Figures::ratio(const std::string& sampler, const std::string& baseline,
                            std::uint32_t samples) const {
  const auto found = std::find_if(ratios.begin(), ratios.end(), [&](const Ratio& r) {
    return r.sampler == sampler && r.baseline == baseline && r.samples == samples;
  });
  return found == ratios.end() ? nullptr : &*found;
}

const Cell* find_cell(const Curve& curve, std::uint32_t samples) {
  const auto found = std::find_if(curve.cells.begin(), curve.cells.end(),
                                  [&](const Cell& c) { return c.samples == samples; });
  return found == curve.cells.end() ? nullptr : &*found;
}

Figures make_figures(const StudyResult& result) {
  Figures figures;
  figures.reference_error = result.reference.error;
  const Clocks clocks(result);
  figures.clocks = clocks.sentence();
  std::map<std::string, std::vector<Column>> columns;
  for (const std::string& sampler : result.settings.samplers) {
    columns[sampler] = columns::of(result, clocks, sampler);
    figures.curves.push_back(curve_of(sampler, columns[sampler]));
  }
  for (const std::string baseline : {"sobol-xor", "sobol-owen"}) {
    if (!columns.contains(baseline)) continue;
    figures.baselines.push_back(baseline);
    for (const std::string& sampler : result.settings.samplers) {
      if (sampler == baseline) continue;
      for (std::size_t i = 0; i < columns[baseline].size(); ++i) {
        Ratio ratio = columns::ratio(columns[sampler], columns[baseline], i);
        ratio.sampler = sampler;
        ratio.baseline = baseline;
        figures.ratios.push_back(ratio);
      }
    }
  }
  // A naive variant stands beside what it is naive of.
  for (const std::string& name : result.settings.samplers) {
    const Variant variant = parse_variant(name);
    if (variant.partition || !columns.contains(variant.sampler)) continue;
    for (std::size_t i = 0; i < columns[variant.sampler].size(); ++i) {
      Ratio ratio = columns::ratio(columns[name], columns[variant.sampler], i);
      ratio.sampler = name;
      ratio.baseline = variant.sampler;
      if (!figures.ratio(name, variant.sampler, ratio.samples)) figures.ratios.push_back(ratio);
    }
  }
  if (!clocks.comparable()) {
    for (Ratio& ratio : figures.ratios)
      ratio.equal_time = ratio.equal_error_time = {kUnknown, kUnknown, kUnknown};
    for (Curve& curve : figures.curves) curve.time_slope = {kUnknown, kUnknown, kUnknown};
  }
  // All splits take about the same time.
  const bool by_time = clocks.comparable() && result.settings.integral != Integral::splitting;
  figures.recommendation = recommend(result.settings, columns, by_time);
  return figures;
}

}  // namespace capcon
