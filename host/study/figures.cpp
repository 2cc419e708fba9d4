#include "study/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "study/clocks.h"

namespace capcon {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
using Kept = std::span<const std::size_t>;  // indices of seeds

/// One sampler at one number of samples: a value for every seed.
struct Column {
  std::uint32_t samples = 0;
  std::vector<double> mse, device, wall, without_points, points;
  bool sure = false;
};

double geometric_mean_of(const std::vector<double>& values, Kept kept) {
  double sum = 0;
  for (const std::size_t i : kept) sum += std::log(values[i]);
  return std::exp(sum / static_cast<double>(kept.size()));
}

/// An MSE estimate can fall to zero or below when the reference's error is taken off: then there is no
/// logarithm, and the cell is not sure anyway.
std::vector<Column> columns_of(const StudyResult& result, const Clocks& clocks, const std::string& sampler) {
  std::map<std::uint32_t, std::map<std::uint32_t, const RunRecord*>> found;  // samples, seed
  for (const RunRecord& r : result.records) {
    if (r.run.sampler == sampler) found[r.run.samples][r.run.seed] = &r;
  }
  constexpr double kShortest = 1e-9;  // a clock may show no time at all
  std::vector<Column> columns;
  for (const auto& [samples, seeds] : found) {
    Column c;
    c.samples = samples;
    for (const auto& [seed, r] : seeds) {
      c.mse.push_back(r->mse - result.reference.error);
      const double factor = clocks.factor(*r);
      const auto time = [&](double seconds) { return std::max(kShortest, factor * seconds); };
      c.device.push_back(time(r->device_seconds));
      c.wall.push_back(time(r->wall_seconds));
      c.without_points.push_back(time(r->wall_seconds - r->point_generation_seconds));
      c.points.push_back(factor * r->point_generation_seconds);
    }
    const bool positive = std::all_of(c.mse.begin(), c.mse.end(), [](double v) { return v > 0; });
    c.sure = positive && mean(c.mse) >= kReferenceMargin * result.reference.error;
    columns.push_back(std::move(c));
  }
  return columns;
}

/// The sure part of a curve for some of the seeds.
struct Path {
  std::vector<double> samples, device, mse;
};

Path path_of(const std::vector<Column>& columns, Kept kept, std::uint32_t from = 1) {
  Path path;
  for (const Column& c : columns) {
    if (!c.sure || c.samples < from) continue;
    path.samples.push_back(c.samples);
    path.device.push_back(geometric_mean_of(c.device, kept));
    path.mse.push_back(geometric_mean_of(c.mse, kept));
  }
  return path;
}

Interval logarithmic(std::size_t seeds, const std::function<double(Kept)>& statistic) {
  return exp(jackknife(seeds, [&](Kept kept) { return std::log(statistic(kept)); }));
}

Curve curve_of(const std::string& sampler, const std::vector<Column>& columns) {
  Curve curve{sampler, {}, {kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}, 0};
  std::size_t seeds = std::numeric_limits<std::size_t>::max();
  for (const Column& c : columns) {
    seeds = std::min(seeds, c.mse.size());
    Cell cell{c.samples,
              {mean(c.mse), kUnknown, kUnknown},
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
      const Path path = path_of(columns, kept, kSlopeFrom);
      return log_log_slope(path.samples, path.mse);
    });
    curve.time_slope = jackknife(seeds, [&](Kept kept) {
      const Path path = path_of(columns, kept, kSlopeFrom);
      return log_log_slope(path.device, path.mse);
    });
  }
  return curve;
}

Ratio ratio_of(const std::vector<Column>& columns, const std::vector<Column>& baseline, std::size_t at) {
  const Column& base = baseline[at];
  const std::size_t seeds = base.mse.size();
  Ratio ratio;
  ratio.samples = base.samples;
  ratio.mse = ratio.equal_error = ratio.equal_time = {kUnknown, kUnknown, kUnknown};
  if (!base.sure) return ratio;
  const auto same = std::find_if(columns.begin(), columns.end(),
                                 [&](const Column& c) { return c.samples == base.samples && c.sure; });
  if (same != columns.end()) {
    ratio.mse = logarithmic(seeds, [&](Kept kept) {
      return geometric_mean_of(same->mse, kept) / geometric_mean_of(base.mse, kept);
    });
  }
  std::vector<std::size_t> all(seeds);
  for (std::size_t i = 0; i < seeds; ++i) all[i] = i;
  const Path whole = path_of(columns, all);
  if (whole.mse.size() < 2) return ratio;
  // The figure itself is never extrapolated; leaving out a seed may push it slightly over the end.
  const double target = geometric_mean_of(base.mse, all);
  if (!std::isnan(log_log_interpolate(whole.mse, whole.samples, target))) {
    ratio.equal_error = logarithmic(seeds, [&](Kept kept) {
      const Path path = path_of(columns, kept);
      return log_log_interpolate(path.mse, path.samples, geometric_mean_of(base.mse, kept), true);
    });
  } else {
    ratio.beyond = target > whole.mse.front() ? -1 : 1;
  }
  const double seconds = geometric_mean_of(base.device, all);
  if (!std::isnan(log_log_interpolate(whole.device, whole.mse, seconds))) {
    ratio.equal_time = logarithmic(seeds, [&](Kept kept) {
      const Path path = path_of(columns, kept);
      return log_log_interpolate(path.device, path.mse, geometric_mean_of(base.device, kept), true) /
             geometric_mean_of(base.mse, kept);
    });
  }
  return ratio;
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
    columns[sampler] = columns_of(result, clocks, sampler);
    figures.curves.push_back(curve_of(sampler, columns[sampler]));
  }
  for (const std::string baseline : {"sobol-xor", "sobol-owen"}) {
    if (!columns.contains(baseline)) continue;
    figures.baselines.push_back(baseline);
    for (const std::string& sampler : result.settings.samplers) {
      if (sampler == baseline) continue;
      for (std::size_t i = 0; i < columns[baseline].size(); ++i) {
        Ratio ratio = ratio_of(columns[sampler], columns[baseline], i);
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
      Ratio ratio = ratio_of(columns[name], columns[variant.sampler], i);
      ratio.sampler = name;
      ratio.baseline = variant.sampler;
      if (!figures.ratio(name, variant.sampler, ratio.samples)) figures.ratios.push_back(ratio);
    }
  }
  if (!clocks.comparable()) {
    for (Ratio& ratio : figures.ratios) ratio.equal_time = {kUnknown, kUnknown, kUnknown};
    for (Curve& curve : figures.curves) curve.time_slope = {kUnknown, kUnknown, kUnknown};
  }
  return figures;
}

}  // namespace capcon
