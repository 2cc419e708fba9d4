#include "integrate/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace capcon::integrate {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr Interval kUnknown{kNone, kNone, kNone};

/// Mean squared error of each group of neighbouring trials. Groups may differ by one trial.
std::vector<double> group_errors(const std::vector<double>& errors) {
  const std::size_t groups = std::min<std::size_t>(20, errors.size());
  std::vector<double> means(groups);  // none of no errors
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t first = g * errors.size() / groups, last = (g + 1) * errors.size() / groups;
    for (std::size_t t = first; t < last; ++t) means[g] += errors[t] * errors[t];
    means[g] /= static_cast<double>(last - first);
  }
  return means;
}

double mean_of(const std::vector<double>& values, std::span<const std::size_t> chosen) {
  double sum = 0;
  for (const std::size_t i : chosen) sum += values[i];
  return sum / static_cast<double>(chosen.size());
}

Interval root(const Interval& v) {
  return {std::sqrt(v.value), std::sqrt(std::max(0.0, v.low)), std::sqrt(v.high)};
}

Interval ratio(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty() || mean(b) <= kRounding * kRounding) return kUnknown;
  return exp(jackknife(a.size(), [&](std::span<const std::size_t> chosen) {
    return std::log(mean_of(a, chosen) / mean_of(b, chosen));
  }));
}

double bias_z(const std::vector<double>& errors) {
  const double error = standard_deviation(errors) / std::sqrt(static_cast<double>(errors.size()));
  return error > kRounding ? mean(errors) / error : 0;
}

std::size_t place(const std::vector<std::string>& names, const char* name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

Analysis analyse(const Experiment& experiment) {
  const Settings& s = experiment.settings;
  Analysis result;
  result.figures.resize(experiment.samples.size());
  result.laws.resize(s.integrands.size() * s.estimators.size());
  std::vector<std::vector<double>> groups(experiment.samples.size());
  for (std::size_t at = 0; at < groups.size(); ++at) groups[at] = group_errors(experiment.samples[at].errors);
  const std::size_t random = place(s.estimators, "random"), owen = place(s.estimators, "sobol-owen");
  for (std::size_t i = 0; i < s.integrands.size(); ++i) {
    for (std::size_t e = 0; e < s.estimators.size(); ++e) {
      std::vector<double> counts;
      std::size_t expected =
          0;  // counts that a slope should have; those without an error to speak of are missing
      std::vector<std::size_t> places;
      for (std::size_t c = 0; c < s.counts.size(); ++c) {
        const std::size_t at = experiment.index(i, e, c);
        if (groups[at].empty()) continue;
        Figure& figure = result.figures[at];
        figure.measured = true;
        figure.rmse = root(mean_interval(groups[at]));
        figure.exact = figure.rmse.value < kRounding;
        figure.bias_z = bias_z(experiment.samples[at].errors);
        const auto beside = [&](std::size_t other) {
          if (other == s.estimators.size() || figure.exact) return kUnknown;
          return ratio(groups[at], groups[experiment.index(i, other, c)]);
        };
        figure.beside_random = beside(random);
        figure.beside_owen = beside(owen);
        if (s.counts[c] < kSlopeFrom) continue;
        ++expected;
        if (!figure.exact) {
          counts.push_back(s.counts[c]);
          places.push_back(at);
        }
      }
      Interval& slope = result.laws[i * s.estimators.size() + e].slope;
      slope = kUnknown;
      if (counts.size() < 2 || counts.size() < expected) continue;
      std::size_t group_count = groups[places.front()].size();
      for (const std::size_t at : places) group_count = std::min(group_count, groups[at].size());
      slope = jackknife(group_count, [&](std::span<const std::size_t> chosen) {
        std::vector<double> errors;
        for (const std::size_t at : places) errors.push_back(std::sqrt(mean_of(groups[at], chosen)));
        return log_log_slope(counts, errors);
      });
    }
  }
  return result;
}

Interval mse_ratio(const Sample& sample, const Sample& baseline) {
  return ratio(group_errors(sample.errors), group_errors(baseline.errors));
}

}  // namespace capcon::integrate
