#include "serve/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace capcon::serve {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Means of some seeds, cell by cell.
struct Means {
  std::vector<double> seconds, relmse;
};

/// Of the two cells around that time.
std::size_t common_seeds(const Curve& curve, double seconds) {
  const std::vector<Cell>& cells = *curve.cells;
  if (cells.empty()) return 0;
  const std::size_t first = first_needed(cells, seconds), n = cells[first].frames.size();
  if (first + 1 == cells.size() || cells[first + 1].frames.empty()) return n;
  return std::min(n, cells[first + 1].frames.size());
}

Means means(const Curve& curve, std::span<const std::size_t> seeds) {
  Means m;
  for (const Cell& cell : *curve.cells) {
    double seconds = 0, error = 0, n = 0;
    const auto add = [&](const Frame& f) { seconds += f.seconds, error += f.relmse, ++n; };
    for (const std::size_t i : seeds)
      if (i < cell.frames.size()) add(cell.frames[i]);
    if (n == 0) std::for_each(cell.frames.begin(), cell.frames.end(), add);
    if (!(error > 0) || !(seconds > 0)) continue;  // lost in the reference's noise
    m.seconds.push_back(seconds / n);
    m.relmse.push_back(error / n);
  }
  return m;
}

std::vector<std::size_t> up_to(std::size_t n) {
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// `statistic(means, extrapolate)`: what is inside with all seeds may lie outside without one of them.
Interval over_seeds(const Curve& curve, double seconds,
                    const std::function<double(const Means&, bool)>& statistic) {
  const std::size_t seeds = common_seeds(curve, seconds);
  if (seeds == 0) return {kNone, kNone, kNone};
  const double value = statistic(means(curve, up_to(seeds)), false);
  if (seeds < 2 || !std::isfinite(value)) return {value, kNone, kNone};
  return jackknife(seeds, [&](auto indices) { return statistic(means(curve, indices), true); });
}

Interval log_error_at(const Curve& curve, double seconds) {
  return over_seeds(curve, seconds, [&](const Means& m, bool beyond) {
    return std::log(log_log_interpolate(m.seconds, m.relmse, seconds, beyond));
  });
}

nlohmann::ordered_json to_json(const Interval& i) {
  const auto value = [](double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
  };
  return {{"value", value(i.value)}, {"low", value(i.low)}, {"high", value(i.high)}};
}

/// A sentence for a sampler whose frames are all too long, or all too short.
std::string why_not(const std::vector<Curve>& curves, double seconds) {
  for (const Curve& curve : curves) {
    if (curve.cells->size() != 1 || curve.cells->front().frames.empty()) continue;
    const double least = mean_seconds(curve.cells->front());
    if (least > seconds)
      return fmt::format(
          " The shortest frame of {} takes {:.2g} s: ask for a longer frame time or a smaller width.",
          curve.sampler, least);
  }
  return "";
}

}  // namespace

double mean_seconds(const Cell& cell) {
  double sum = 0;
  for (const Frame& frame : cell.frames) sum += frame.seconds;
  return cell.frames.empty() ? kNone : sum / static_cast<double>(cell.frames.size());
}

std::size_t first_needed(const std::vector<Cell>& cells, double seconds) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < cells.size(); ++i)
    if (mean_seconds(cells[i]) <= seconds) first = i;
  return first;
}

Interval relmse_at(const Curve& curve, double seconds) {
  return exp(log_error_at(curve, seconds));
}

Interval time_ratio(const Curve& curve, const Curve& other, double seconds) {
  const Interval error = log_error_at(curve, seconds);
  const Interval theirs = over_seeds(other, seconds, [&](const Means& m, bool beyond) {
    return std::log(log_log_interpolate(m.relmse, m.seconds, std::exp(error.value), beyond));
  });
  // The first curve's own uncertainty, carried over to time by the slope of the other's.
  const Means m = means(other, up_to(common_seeds(other, seconds)));
  const double slope = log_log_slope(m.relmse, m.seconds);
  const double mine = std::abs(slope) * (error.high - error.low) / 2, its = (theirs.high - theirs.low) / 2;
  const double value = theirs.value - std::log(seconds), half = std::hypot(mine, its);
  return exp(Interval{value, value - half, value + half});
}

nlohmann::ordered_json answer(const std::vector<Curve>& curves, double seconds, const std::string& device) {
  nlohmann::ordered_json out = {{"seconds", seconds}, {"decided", false}};
  std::vector<std::pair<Interval, const Curve*>> order;
  std::vector<std::pair<double, std::string>> errors;
  for (const Curve& curve : curves) {
    const Interval error = relmse_at(curve, seconds);
    out["relmse"][curve.sampler] = to_json(error);
    if (std::isfinite(error.value) && std::isfinite(error.low)) order.emplace_back(error, &curve);
    errors.emplace_back(error.value, curve.sampler);
  }
  std::sort(errors.begin(), errors.end());
  const bool all = std::all_of(errors.begin(), errors.end(), [](const auto& e) { return e.first > 0; });
  const std::string so_far =
      all && errors.size() > 1
          ? fmt::format(" So far {} errs least and {} {:.2g} times as much.", errors.front().second,
                        errors[1].second, errors[1].first / errors.front().first)
          : "";
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first.value < b.first.value; });
  if (order.size() < curves.size()) {
    out["headline"] = "Not known yet.";
    out["text"] = fmt::format("{} of {} samplers have been measured twice or more at {:g} s a frame.{}{}",
                              order.size(), curves.size(), seconds, why_not(curves, seconds), so_far);
    return out;
  }
  const Curve& best = *order.front().second;
  const Interval error = order.front().first;
  std::vector<std::string> words, open = {best.sampler};
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Interval ratio = time_ratio(best, *order[i].second, seconds);
    const std::string& name = order[i].second->sampler;
    out["time_ratio"][name] = to_json(ratio);
    const bool apart = order[i].first.low > error.high;  // of errors: also where no time was long enough
    const bool measured = std::isfinite(ratio.low);
    if (!(measured && ratio.low > 1) && !apart) open.push_back(name);
    if (measured && (ratio.low > 1 || !apart))
      words.push_back(fmt::format("{} needs {:.2f} ({:.2f} to {:.2f}) times the time for it", name,
                                  ratio.value, ratio.low, ratio.high));
    else
      words.push_back(fmt::format("{} errs {:.2g} times as much", name, order[i].first.value / error.value));
  }
  const bool decided = open.size() == 1;
  out["best"] = best.sampler;
  out["decided"] = decided;
  out["headline"] = decided ? fmt::format("Use {}.", best.sampler)
                            : fmt::format("{}: not decided yet.", fmt::join(open, " or "));
  out["text"] = fmt::format(
      "At {:g} s a frame on {} the error (relMSE) of {} is {:.2e} (95 %: {:.2e} to {:.2e}), by {} seeds. {}.",
      seconds, device, best.sampler, error.value, error.low, error.high, common_seeds(best, seconds),
      fmt::join(words, "; "));
  return out;
}

}  // namespace capcon::serve
