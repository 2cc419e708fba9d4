#include "study/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace capcon::columns {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Interval logarithmic(std::size_t seeds, const std::function<double(Kept)>& statistic) {
  return exp(jackknife(seeds, [&](Kept kept) { return std::log(statistic(kept)); }));
}

}  // namespace

double geometric_mean_of(const std::vector<double>& values, Kept kept) {
  double sum = 0;
  for (const std::size_t i : kept) sum += std::log(values[i]);
  return std::exp(sum / static_cast<double>(kept.size()));
}

std::vector<Column> of(const StudyResult& result, const Clocks& clocks, const std::string& sampler) {
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
      c.relmse.push_back(r->relmse);
      if (r->flip >= 0) c.flip.push_back(r->flip);
    }
    const bool positive = std::all_of(c.mse.begin(), c.mse.end(), [](double v) { return v > 0; });
    c.sure = positive && mean(c.mse) >= kReferenceMargin * result.reference.error;
    if (c.flip.size() < c.mse.size()) c.flip.clear();  // some of it is older than the measure
    columns.push_back(std::move(c));
  }
  return columns;
}

std::vector<Column> first_seeds(std::vector<Column> all, std::size_t seeds) {
  for (Column& c : all) {
    for (auto* values : {&c.mse, &c.device, &c.wall, &c.without_points, &c.points, &c.relmse, &c.flip}) {
      if (values->size() > seeds) values->resize(seeds);
    }
  }
  return all;
}

Path path(const std::vector<Column>& columns, Kept kept, std::uint32_t from) {
  Path result;
  for (const Column& c : columns) {
    if (!c.sure || c.samples < from) continue;
    result.samples.push_back(c.samples);
    result.device.push_back(geometric_mean_of(c.device, kept));
    result.mse.push_back(geometric_mean_of(c.mse, kept));
  }
  return result;
}

Ratio ratio(const std::vector<Column>& columns, const std::vector<Column>& baseline, std::size_t at) {
  const Column& base = baseline[at];
  const std::size_t seeds = base.mse.size();
  Ratio result;
  result.samples = base.samples;
  result.mse = result.equal_error = result.equal_error_time =
      result.equal_time = {kUnknown, kUnknown, kUnknown};
  if (!base.sure) return result;
  const auto same = std::find_if(columns.begin(), columns.end(),
                                 [&](const Column& c) { return c.samples == base.samples && c.sure; });
  if (same != columns.end()) {
    result.mse = logarithmic(seeds, [&](Kept kept) {
      return geometric_mean_of(same->mse, kept) / geometric_mean_of(base.mse, kept);
    });
  }
  std::vector<std::size_t> all(seeds);
  for (std::size_t i = 0; i < seeds; ++i) all[i] = i;
  const Path whole = path(columns, all);
  if (whole.mse.size() < 2) return result;
  // The figure itself is never extrapolated; leaving out a seed may push it slightly over the end.
  const double target = geometric_mean_of(base.mse, all);
  if (!std::isnan(log_log_interpolate(whole.mse, whole.samples, target))) {
    result.equal_error = logarithmic(seeds, [&](Kept kept) {
      const Path curve = path(columns, kept);
      return log_log_interpolate(curve.mse, curve.samples, geometric_mean_of(base.mse, kept), true);
    });
    result.equal_error_time = logarithmic(seeds, [&](Kept kept) {
      const Path curve = path(columns, kept);
      return log_log_interpolate(curve.mse, curve.device, geometric_mean_of(base.mse, kept), true) /
             geometric_mean_of(base.device, kept);
    });
  } else {
    result.beyond = target > whole.mse.front() ? -1 : 1;
  }
  const double seconds = geometric_mean_of(base.device, all);
  if (!std::isnan(log_log_interpolate(whole.device, whole.mse, seconds))) {
    result.equal_time = logarithmic(seeds, [&](Kept kept) {
      const Path curve = path(columns, kept);
      return log_log_interpolate(curve.device, curve.mse, geometric_mean_of(base.device, kept), true) /
             geometric_mean_of(base.mse, kept);
    });
  }
  return result;
}

}  // namespace capcon::columns
