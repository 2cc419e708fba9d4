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

double log_error(const Means& m, double seconds, bool beyond) {
  return std::log(log_log_interpolate(m.seconds, m.relmse, seconds, beyond));
}

/// `statistic(seeds, beyond)` of the first `seeds`; what is inside with all of them may lie beyond the curve
/// without one.
Interval over_seeds(std::size_t seeds,
                    const std::function<double(std::span<const std::size_t>, bool)>& statistic) {
  if (seeds == 0) return {kNone, kNone, kNone};
  const double value = statistic(up_to(seeds), false);
  if (seeds < 2 || !std::isfinite(value)) return {value, kNone, kNone};
  return jackknife(seeds, [&](auto indices) { return statistic(indices, true); });
}

/// Of two curves together: their frames of one seed were rendered at about the same time, and what held up
/// both cancels out.
Interval over_seeds(const Curve& a, const Curve& b, double seconds,
                    const std::function<double(const Means&, const Means&, bool)>& statistic) {
  return exp(over_seeds(
      std::min(common_seeds(a, seconds), common_seeds(b, seconds)),
      [&](auto seeds, bool beyond) { return statistic(means(a, seeds), means(b, seeds), beyond); }));
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
  return exp(over_seeds(common_seeds(curve, seconds), [&](auto seeds, bool beyond) {
    return log_error(means(curve, seeds), seconds, beyond);
  }));
}

Interval error_ratio(const Curve& curve, const Curve& other, double seconds) {
  return over_seeds(curve, other, seconds, [&](const Means& mine, const Means& theirs, bool beyond) {
    return log_error(theirs, seconds, beyond) - log_error(mine, seconds, beyond);
  });
}

Interval time_ratio(const Curve& curve, const Curve& other, double seconds) {
  return over_seeds(curve, other, seconds, [&](const Means& mine, const Means& theirs, bool beyond) {
    const double error = std::exp(log_error(mine, seconds, beyond));
    return std::log(log_log_interpolate(theirs.relmse, theirs.seconds, error, beyond) / seconds);
  });
}

nlohmann::ordered_json answer(const std::vector<Curve>& curves, double seconds, const std::string& device) {
  nlohmann::ordered_json out = {{"seconds", seconds}, {"decided", false}};
  std::vector<std::pair<Interval, const Curve*>> order;
  std::vector<std::pair<double, std::string>> errors;
  for (const Curve& curve : curves) {
    const Interval error = relmse_at(curve, seconds);
    out["relmse"][curve.sampler] = to_json(error);
    if (std::isfinite(error.value) && std::isfinite(error.low)) order.emplace_back(error, &curve);
    errors.emplace_back(std::isfinite(error.value) ? error.value : 0, curve.sampler);
  }
  std::sort(errors.begin(), errors.end());
  const std::string so_far =
      errors.size() > 1 && errors.front().first > 0
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
    const Curve& other = *order[i].second;
    const Interval errs = error_ratio(best, other, seconds), needs = time_ratio(best, other, seconds);
    out["error_ratio"][other.sampler] = to_json(errs);
    out["time_ratio"][other.sampler] = to_json(needs);
    if (!(errs.low > 1)) open.push_back(other.sampler);
    words.push_back(fmt::format("{} errs {:.2f} ({:.2f} to {:.2f}) times as much", other.sampler, errs.value,
                                errs.low, errs.high));
    if (std::isfinite(needs.low))
      words.back() += fmt::format(" and needs {:.2f} ({:.2f} to {:.2f}) times the time for the same",
                                  needs.value, needs.low, needs.high);
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
