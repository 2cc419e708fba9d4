#include "study/regression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "study/format.h"
#include "study/run_record.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What makes a figure mean something else; not what the samplers make, nor where.
constexpr std::array kSettings = {"integral",        "scene_fingerprint",
                                  "width",           "height",
                                  "radius",          "combined",
                                  "pixel_samples",   "paths",
                                  "limit",           "gather",
                                  "clamping",        "samples",
                                  "seeds",           "reference_samples",
                                  "reference_groups"};

/// A figure in logarithms: its value and half its interval. Infinite where it is beyond what was measured.
struct Figure {
  double value = 0, half = 0;
  std::string text;
};

std::optional<Figure> figure_of(const json& ratio, const json& study, bool by_mse) {
  const json& samples = study.at("settings").at("samples");
  const json& interval = ratio.at(by_mse ? "mse_ratio" : "equal_error_samples");
  const int beyond = by_mse ? 0 : ratio.at("equal_error_beyond").get<int>();
  if (beyond < 0)
    return Figure{-std::numeric_limits<double>::infinity(), 0, fmt::format("< {}", samples.front().dump())};
  if (beyond > 0)
    return Figure{std::numeric_limits<double>::infinity(), 0, fmt::format("> {}", samples.back().dump())};
  for (const char* end : {"value", "low", "high"})
    if (!interval.at(end).is_number() || !(interval.at(end).get<double>() > 0)) return std::nullopt;
  const Interval x{interval.at("value").get<double>(), interval.at("low").get<double>(),
                   interval.at("high").get<double>()};
  return Figure{std::log(x.value), std::log(x.high / x.low) / 2, with_range(x)};
}

const json* find_ratio(const json& study, const json& like) {
  for (const json& ratio : study.at("ratios")) {
    const auto same = [&](const char* name) { return ratio.at(name) == like.at(name); };
    if (same("sampler") && same("baseline") && same("samples")) return &ratio;
  }
  return nullptr;
}

/// How many times as much it is at least known to be, in logarithms, and how sure that must be; the ends of
/// what was measured stand for figures beyond.
struct Change {
  double difference, half;
};
Change change_of(const Figure& was, const Figure& is, const json& samples, bool by_mse) {
  if (by_mse) return {is.value - was.value, std::hypot(was.half, is.half)};
  const double least = std::log(samples.front().get<double>()), most = std::log(samples.back().get<double>());
  if (is.value < least) return {0, 0};  // it cannot be better
  const double from = std::max(was.value, std::isinf(was.value) ? least : was.value);
  const double to = std::isinf(is.value) ? most : is.value;
  return {to - from, std::hypot(was.half, is.half)};
}

}  // namespace

Baseline read_baseline(const fs::path& file) {
  Baseline baseline{file, {}};
  try {
    baseline.json = parse_study_json(read_file(file));
    const json& j = baseline.json;
    j.at("settings").at("samplers").get<std::vector<std::string>>();
    const auto samples = j.at("settings").at("samples").get<std::vector<std::uint32_t>>();
    if (std::count(samples.begin(), samples.end(), 0u) > 0 || !std::is_sorted(samples.begin(), samples.end()))
      throw std::out_of_range("samples");
    const bool whole =
        j.at("study").is_string() && !j.at("settings").at("samples").empty() && j.at("ratios").is_array();
    if (!whole) throw std::out_of_range("not whole");
    for (const json& ratio : j.at("ratios")) {
      for (const char* name : {"sampler", "baseline"}) ratio.at(name).get_ref<const std::string&>();
      ratio.at("samples").get<std::uint32_t>();
      for (const bool by_mse : {false, true}) figure_of(ratio, j, by_mse);
      // The same figure twice: which one counts?
      if (find_ratio(j, ratio) != &ratio) throw std::out_of_range("twice");
    }
  } catch (const json::exception&) {
    throw InputError(SourcePlace{file.string(), 0, 0},
                     "this is not the study.json that a study writes; make it with capcon study ... -o DIR");
  } catch (const std::out_of_range&) {
    throw InputError(SourcePlace{file.string(), 0, 0},
                     "this is not the study.json that a study writes; make it with capcon study ... -o DIR");
  }
  return baseline;
}

void check_comparable(const Baseline& baseline, const json& settings) {
  const json& then = baseline.json.at("settings");
  for (const char* name : kSettings) {
    const json was = then.value(name, json()), is = settings.value(name, json());
    if (was == is) continue;
    throw InputError(
        SourcePlace{baseline.file.string(), 0, 0},
        fmt::format("{} is {} there and {} in this study; give the baseline's options, or make it anew", name,
                    was.dump(), is.dump()));
  }
  if (settings.at("seeds") == 1)
    throw InputError("--check needs intervals, and those two seeds at least: --seeds 8");
  const json& measured = settings.at("samplers");
  for (const json& sampler : then.at("samplers")) {
    if (std::find(measured.begin(), measured.end(), sampler) != measured.end()) continue;
    throw InputError(
        SourcePlace{baseline.file.string(), 0, 0},
        fmt::format("{} is there and not in this study; add it to --samplers", sampler.get<std::string>()));
  }
}

Regression find_regressions(const Baseline& baseline, const json& study) {
  Regression result;
  const json& samples = study.at("settings").at("samples");
  for (const json& before : baseline.json.at("ratios")) {
    // A naive variant beside its own sampler says nothing bad where the latter got better.
    if (before.at("baseline") != "sobol-xor" && before.at("baseline") != "sobol-owen") continue;
    const bool by_mse = study.at("study") == "splitting" || before.at("equal_error_beyond") == 1;
    const auto was = figure_of(before, baseline.json, by_mse);
    const json* now = find_ratio(study, before);
    const auto is = now ? figure_of(*now, study, by_mse) : std::nullopt;
    if (!was || !is) {
      ++result.skipped;
      continue;
    }
    ++result.compared;
    const Change change = change_of(*was, *is, samples, by_mse);
    if (!(change.difference > change.half) || change.difference < 1e-9) continue;
    result.worse.push_back({before.at("sampler").get<std::string>(), before.at("baseline").get<std::string>(),
                            before.at("samples").get<std::uint32_t>(), was->text, is->text,
                            std::exp(change.difference), by_mse});
  }
  return result;
}

std::string sentence(const Worsening& w, const json& study) {
  const char* unit = study.at("study") == "igi" ? "sets" : "samples";
  if (w.by_mse)
    return fmt::format("{}: MSE beside that of {} at {} {} is {}, was {}: {} times as much", w.sampler,
                       w.baseline, w.samples, unit, w.is, w.was, short_number(w.factor));
  return fmt::format("{}: {} needed for the error of {} {} of {} are {}, were {}: {} times as many",
                     w.sampler, unit, w.samples, unit, w.baseline, w.is, w.was, short_number(w.factor));
}

json to_json(const Regression& regression, const Baseline& baseline) {
  json worse = json::array();
  for (const Worsening& w : regression.worse) {
    worse.push_back({{"sampler", w.sampler},
                     {"baseline", w.baseline},
                     {"samples", w.samples},
                     {"was", w.was},
                     {"is", w.is},
                     {"figure", w.by_mse ? "mse_ratio" : "equal_error_samples"},
                     {"factor", w.factor}});
  }
  return {{"against", baseline.file.string()},
          {"compared", regression.compared},
          {"skipped", regression.skipped},
          {"worse", worse}};
}

}  // namespace capcon
