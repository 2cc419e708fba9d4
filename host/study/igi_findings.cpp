#include "study/igi_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "study/coarse.h"
#include "study/format.h"

namespace capcon {
namespace {

std::string sets_text(std::uint32_t count) {
  return fmt::format("{} {}", count, count == 1 ? "set" : "sets");
}

bool measured(const StudySettings& s, const std::string& sampler) {
  return std::find(s.samplers.begin(), s.samplers.end(), sampler) != s.samplers.end();
}

/// "0.81 (0.79–0.83) at 1 set, ..." of every count that has the figure.
std::string by_count(const StudySettings& s, const std::function<Interval(std::uint32_t)>& figure) {
  std::vector<std::string> parts;
  for (const std::uint32_t n : s.samples) {
    const Interval v = figure(n);
    if (!std::isnan(v.value)) parts.push_back(fmt::format("{} at {}", with_range(v), sets_text(n)));
  }
  return enumerate(parts);
}

std::string error_sentence(const StudySettings& s, const Figures& figures, const std::string& sampler,
                           const std::string& baseline) {
  const std::string ratios = by_count(s, [&](std::uint32_t n) {
    const Ratio* r = figures.ratio(sampler, baseline, n);
    return r ? r->mse : Interval{NAN, NAN, NAN};
  });
  return ratios.empty() ? "" : fmt::format("MSE of {} beside that of {}: {}.", sampler, baseline, ratios);
}

std::string equal_time_sentence(const StudySettings& s, const Figures& figures, const std::string& sampler,
                                const std::string& baseline) {
  const std::string ratios = by_count(s, [&](std::uint32_t n) {
    const Ratio* r = figures.ratio(sampler, baseline, n);
    return r ? r->equal_time : Interval{NAN, NAN, NAN};
  });
  return ratios.empty()
             ? ""
             : fmt::format("The same in the device time that {}'s sets take: {}.", baseline, ratios);
}

std::string lowest_sentence(const StudySettings& s, const Figures& figures) {
  std::vector<std::string> parts;
  for (const std::uint32_t n : s.samples) {
    const Curve* lowest = nullptr;
    for (const Curve& curve : figures.curves) {
      const Cell* cell = find_cell(curve, n);
      if (!cell || !cell->sure) continue;
      if (!lowest || cell->mse.value < find_cell(*lowest, n)->mse.value) lowest = &curve;
    }
    if (!lowest) continue;
    const Interval& mse = find_cell(*lowest, n)->mse;
    const std::string around = percent_around(mse);
    parts.push_back(fmt::format("{} at {} ({}{}{})", lowest->sampler, sets_text(n), scientific(mse.value),
                                around.empty() ? "" : " ", around));
  }
  return parts.empty() ? "" : fmt::format("Lowest MSE of all: {}.", enumerate(parts));
}

std::string coarse_sentence(const StudySettings& s, const Figures& figures) {
  const Noise& noise = figures.noise;
  std::vector<std::string> parts;
  for (const std::string& sampler : s.samplers) {
    const NoiseCell* cell = noise.cell(sampler, noise.map_samples);
    if (cell && !std::isnan(cell->coarse.value))
      parts.push_back(fmt::format("{} of {}'s", with_range(cell->coarse), sampler));
  }
  if (parts.empty()) return {};
  return fmt::format(
      "At {} a box filter of {} x {} pixels leaves of the squared error {}; of errors that are independent "
      "from "
      "pixel to pixel it would leave {}.",
      sets_text(noise.map_samples), kCoarseBlock, kCoarseBlock, enumerate(parts),
      short_number(noise.coarse_by_chance));
}

std::string coarse_ratio_sentence(const StudySettings& s, const Figures& figures, const std::string& sampler,
                                  const std::string& baseline) {
  const std::string ratios = by_count(s, [&](std::uint32_t n) {
    const NoiseCell* a = figures.noise.cell(sampler, n);
    const NoiseCell* b = figures.noise.cell(baseline, n);
    return a && b ? coarse_ratio(*a, *b) : Interval{NAN, NAN, NAN};
  });
  return ratios.empty()
             ? ""
             : fmt::format("That coarse error of {} beside that of {}: {}.", sampler, baseline, ratios);
}

/// Mean images that are farther from the reference than chance explains.
std::string bias_sentence(const Figures& figures) {
  std::vector<std::string> shown;
  std::size_t asked = 0;
  for (const NoiseCell& c : figures.noise.cells) {
    if (std::isnan(c.bias_square.low)) continue;
    ++asked;
    if (!c.bias_square.above(0)) continue;
    shown.push_back(fmt::format("{} at {} ({}, by chance {})", c.sampler, sets_text(c.samples),
                                scientific(c.mean_error), scientific(c.chance)));
  }
  if (asked == 0) return {};
  if (shown.empty()) {
    return fmt::format(
        "No mean over the seeds is shown to be farther from the reference than chance puts it ({} means).",
        asked);
  }
  return fmt::format(
      "The mean over the seeds is farther from the reference than chance puts it for {}, of {} means; of "
      "forty "
      "such calls about one is chance.",
      enumerate(shown), asked);
}

}  // namespace

std::vector<std::string> make_igi_findings(const StudySettings& s, const Figures& figures) {
  std::vector<std::string> findings;
  const auto add = [&](std::string sentence) {
    if (!sentence.empty()) findings.push_back(std::move(sentence));
  };
  for (const char* sampler : {"capcon", "capcon-domain"}) {
    if (!measured(s, sampler)) continue;
    for (const std::string& baseline : figures.baselines) {
      add(error_sentence(s, figures, sampler, baseline));
      // The other equal times are in the tables: sets of all samplers take about as long.
      if (baseline == figures.baselines.front() && std::string(sampler) == "capcon")
        add(equal_time_sentence(s, figures, sampler, baseline));
    }
  }
  for (const std::string& name : s.samplers) {
    const Variant variant = parse_variant(name);
    if (!variant.partition) add(error_sentence(s, figures, name, variant.sampler));
  }
  add(lowest_sentence(s, figures));
  add(coarse_sentence(s, figures));
  for (const char* sampler : {"capcon", "capcon-domain"}) {
    if (measured(s, sampler) && measured(s, "sobol-xor"))
      add(coarse_ratio_sentence(s, figures, sampler, "sobol-xor"));
  }
  add(bias_sentence(figures));
  if (findings.empty()) findings.push_back(fmt::format("{} samplers compared.", s.samplers.size()));
  return findings;
}

}  // namespace capcon
