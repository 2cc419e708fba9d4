// What the page is told of a comparison.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "serve/answer.h"
#include "serve/comparison.h"

namespace capcon::serve {
namespace {

using nlohmann::ordered_json;

ordered_json interval(const std::vector<double>& values) {
  const Interval i = mean_interval(values);
  const auto value = [](double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(); };
  return {{"value", value(i.value)}, {"low", value(i.low)}, {"high", value(i.high)}};
}

}  // namespace

/// The frame time that is asked about, or that of the most samples where no sampler takes as long.
double Comparison::asked() const {
  double least = settings_.frame_seconds;
  for (const Series& s : series_) {
    const Cell& last = s.cells.back();
    if (last.frames.empty() || last.count * 2 <= largest_count(settings_, s.sampler) ||
        mean_seconds(last) >= settings_.frame_seconds)
      return settings_.frame_seconds;
    least = std::min(least, mean_seconds(last));
  }
  return least;
}

ordered_json Comparison::snapshot() const {
  const std::lock_guard lock(mutex_);
  ordered_json out = {{"id", id_},
                      {"state", cancelled_ ? "cancelled" : state_},
                      {"message", message_},
                      {"part", fraction_.load()},
                      {"device", device_},
                      {"width", width_},
                      {"height", height_},
                      {"scene", settings_.scene.name},
                      {"radius", settings_.radius}};
  double error = 0;
  for (const double v : reference_variance_) error += v;
  out["reference"] = {{"groups", groups_},
                      {"least", least_groups_},
                      {"of", most_groups_},
                      {"count", group_count_},
                      {"mse", reference_variance_.empty() ? 0 : error / double(reference_variance_.size())}};
  std::uint32_t common = std::numeric_limits<std::uint32_t>::max();  // largest count that all have
  for (const Series& s : series_) {
    std::uint32_t largest = 0;
    for (const Cell& c : s.cells) largest = c.frames.empty() ? largest : c.count;
    common = std::min(common, largest);
  }
  std::vector<Curve> curves;
  for (const Series& s : series_) {
    ordered_json one = {{"sampler", s.sampler}, {"frames", s.frames}, {"device_seconds", s.spent}};
    std::uint32_t shown = 0;
    double rays = 0;
    for (const Cell& cell : s.cells) {
      if (cell.frames.empty()) continue;
      std::vector<double> mse, relmse, times;
      double seconds = 0, traced = 0;
      for (const Frame& f : cell.frames) {
        mse.push_back(f.mse);
        relmse.push_back(f.relmse);
        times.push_back(f.seconds);
        seconds += f.seconds;
        traced += f.rays;
      }
      rays += traced;
      const double mean = seconds / double(cell.frames.size());
      one["cells"].push_back({{"count", cell.count},
                              {"seeds", cell.frames.size()},
                              {"seconds", mean},
                              {"time", interval(times)},
                              {"rays_per_second", seconds > 0 ? traced / seconds : 0},
                              {"mse", interval(mse)},
                              {"relmse", interval(relmse)}});
      if (settings_.equal_time ? (shown == 0 || mean <= settings_.frame_seconds) : cell.count <= common)
        shown = cell.count;
    }
    one["rays_per_second"] = s.spent > 0 ? rays / s.spent : 0;
    if (shown > 0)
      one["shown"] = {{"count", shown},
                      {"command", command_of(settings_, s.sampler, shown, 1, width_, height_)}};
    out["series"].push_back(std::move(one));
    curves.push_back({s.sampler, &s.cells});
  }
  out["answer"] = answer(curves, asked(), device_);
  out["frame_seconds"] = settings_.frame_seconds;
  return out;
}

}  // namespace capcon::serve
