#include "serve/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace capcon::serve {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Means of some seeds, cell by cell.
struct Means {
  std::vector<double> seconds, relmse;
};

std::size_t common_seeds(const Curve& curve) {
  std::size_t least = curve.cells->empty() ? 0 : std::numeric_limits<std::size_t>::max();
  for (const Cell& cell : *curve.cells) least = std::min(least, cell.frames.size());
  return least;
}

Means means(const Curve& curve, std::span<const std::size_t> seeds) {
  Means m;
  for (const Cell& cell : *curve.cells) {
    double seconds = 0, error = 0;
    for (const std::size_t i : seeds) seconds += cell.frames[i].seconds, error += cell.frames[i].relmse;
    if (!(error > 0) || !(seconds > 0)) continue;  // lost in the reference's noise
    m.seconds.push_back(seconds / static_cast<double>(seeds.size()));
    m.relmse.push_back(error / static_cast<double>(seeds.size()));
  }
  return m;
}

double log_error_at(const Means& m, double seconds) {
  return std::log(log_log_interpolate(m.seconds, m.relmse, seconds));
}

Interval over_seeds(const Curve& curve, const std::function<double(const Means&)>& statistic) {
  const std::size_t seeds = common_seeds(curve);
  std::vector<std::size_t> all(seeds);
  for (std::size_t i = 0; i < seeds; ++i) all[i] = i;
  if (seeds == 0) return {kNone, kNone, kNone};
  const double value = statistic(means(curve, all));
  if (seeds < 2) return {value, kNone, kNone};
  return jackknife(seeds, [&](auto indices) { return statistic(means(curve, indices)); });
}

nlohmann::ordered_json to_json(const Interval& i) {
  const auto value = [](double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
  };
  return {{"value", value(i.value)}, {"low", value(i.low)}, {"high", value(i.high)}};
}

}  // namespace

Interval relmse_at(const Curve& curve, double seconds) {
  return exp(over_seeds(curve, [&](const Means& m) { return log_error_at(m, seconds); }));
}

Interval time_ratio(const Curve& curve, const Curve& other, double seconds) {
  const Interval error = over_seeds(curve, [&](const Means& m) { return log_error_at(m, seconds); });
  const auto time_for = [](const Means& m, double log_error) {
    return std::log(log_log_interpolate(m.relmse, m.seconds, std::exp(log_error)));
  };
  const Interval theirs = over_seeds(other, [&](const Means& m) { return time_for(m, error.value); });
  // The first curve's own uncertainty, carried over to time by the slope of the other's.
  const std::size_t seeds = common_seeds(other);
  std::vector<std::size_t> all(seeds);
  for (std::size_t i = 0; i < seeds; ++i) all[i] = i;
  const double slope = seeds < 1 ? kNone : [&] {
    const Means m = means(other, all);
    return log_log_slope(m.relmse, m.seconds);
  }();
  const double mine = std::abs(slope) * (error.high - error.low) / 2, its = (theirs.high - theirs.low) / 2;
  const double value = theirs.value - std::log(seconds), half = std::hypot(mine, its);
  return exp(Interval{value, value - half, value + half});
}

nlohmann::ordered_json answer(const std::vector<Curve>& curves, double seconds, const std::string& device) {
  nlohmann::ordered_json out = {{"seconds", seconds}, {"decided", false}};
  std::vector<std::pair<Interval, const Curve*>> order;
  for (const Curve& curve : curves) {
    const Interval error = relmse_at(curve, seconds);
    out["relmse"][curve.sampler] = to_json(error);
    if (std::isfinite(error.value) && std::isfinite(error.low)) order.emplace_back(error, &curve);
  }
  if (order.size() < curves.size()) {
    out["text"] = fmt::format(
        "At {:g} s a frame on this device: not known yet. {} of {} samplers have been measured there twice "
        "or more.",
        seconds, order.size(), curves.size());
    return out;
  }
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first.value < b.first.value; });
  const Curve& best = *order.front().second;
  const Interval error = order.front().first;
  std::string text = fmt::format("At {:g} s a frame on {}: {}, relMSE {:.2e} (95 %: {:.2e} to {:.2e}).",
                                 seconds, device, best.sampler, error.value, error.low, error.high);
  std::vector<std::string> worse, equal;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Interval ratio = time_ratio(best, *order[i].second, seconds);
    const std::string& name = order[i].second->sampler;
    out["time_ratio"][name] = to_json(ratio);
    const bool apart = order[i].first.low > error.high;  // of errors: also where no time was long enough
    if (std::isfinite(ratio.low) && ratio.low > 1)
      worse.push_back(fmt::format("{} needs {:.2f} ({:.2f} to {:.2f}) times the time for it", name,
                                  ratio.value, ratio.low, ratio.high));
    else if (apart)
      worse.push_back(fmt::format("{} errs {:.2f} times as much, and needs longer for it than was measured",
                                  name, order[i].first.value / error.value));
    else
      equal.push_back(name);
  }
  if (!worse.empty()) text += fmt::format(" {}.", fmt::join(worse, "; "));
  if (!equal.empty())
    text += fmt::format(" Not decided beside {}: intervals overlap.", fmt::join(equal, ", "));
  out["best"] = best.sampler;
  out["decided"] = equal.empty();
  out["text"] = text;
  return out;
}

}  // namespace capcon::serve
