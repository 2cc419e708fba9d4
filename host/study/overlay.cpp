#include "study/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "base/error.h"
#include "study/columns.h"
#include "study/format.h"

namespace capcon {
using nlohmann::json;

namespace {

/// What makes a figure mean something else: not who measured it, what the samplers made, or how many of them.
constexpr std::array kSettings = {"integral",      "width", "height", "radius", "combined",
                                  "pixel_samples", "paths", "limit",  "gather", "clamping"};

void check_same(const KeptStudy& a, const KeptStudy& b) {
  const auto refuse = [&](const std::string& what, const std::string& one, const std::string& other) {
    throw InputError(
        fmt::format("{} and {} cannot be laid over each other: {} is {} in one and {} in the other",
                    a.folder.string(), b.folder.string(), what, one, other));
  };
  const json one = to_json(a.result.settings), other = to_json(b.result.settings);
  for (const char* name : kSettings) {
    const json was = one.value(name, json()), is = other.value(name, json());
    if (was != is) refuse(std::string(name) == "integral" ? "the study" : name, was.dump(), is.dump());
  }
  if (one.at("scene_fingerprint") == other.at("scene_fingerprint")) return;
  if (a.result.settings.scene != b.result.settings.scene)
    refuse("the scene", a.result.settings.scene, b.result.settings.scene);
  refuse("what is in " + a.result.settings.scene, one.at("scene_fingerprint").get<std::string>(),
         other.at("scene_fingerprint").get<std::string>());
}

template <class T>
std::vector<T> common(const std::vector<KeptStudy>& studies, const std::vector<T> StudySettings::*list) {
  std::vector<T> result;
  for (const T& item : studies.front().result.settings.*list) {
    if (std::all_of(studies.begin(), studies.end(), [&](const KeptStudy& s) {
          const auto& all = s.result.settings.*list;
          return std::find(all.begin(), all.end(), item) != all.end();
        }))
      result.push_back(item);
  }
  return result;
}

std::vector<std::string> names_of(const std::vector<KeptStudy>& studies) {
  std::vector<std::string> names;
  std::set<std::string> different;
  for (const KeptStudy& study : studies) {
    const auto whole = std::filesystem::absolute(study.folder).lexically_normal();
    names.push_back((whole.has_filename() ? whole : whole.parent_path()).filename().string());
    different.insert(names.back());
  }
  if (different.size() == studies.size()) return names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = studies[i].folder.string();
  return names;
}

bool same_errors(const StudyResult& a, const StudyResult& b) {
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, double> first;
  for (const RunRecord& r : a.records) first[{r.run.sampler, r.run.samples, r.run.seed}] = r.mse;
  bool any = false;
  for (const RunRecord& r : b.records) {
    const auto it = first.find({r.run.sampler, r.run.samples, r.run.seed});
    if (it == first.end()) continue;
    any = true;
    if (it->second != r.mse) return false;
  }
  return any;
}

Beside beside(const Overlay& o, std::size_t k) {
  Beside result;
  result.study = k;
  result.same_errors = same_errors(o.studies[0].result, o.studies[k].result);
  const Clocks first(o.studies[0].result), other(o.studies[k].result);
  for (const std::string& sampler : o.samplers) {
    const auto base = columns::first_seeds(columns::of(o.studies[0].result, first, sampler), o.seeds);
    const auto mine = columns::first_seeds(columns::of(o.studies[k].result, other, sampler), o.seeds);
    for (std::size_t i = 0; i < base.size(); ++i) {
      if (std::find(o.samples.begin(), o.samples.end(), base[i].samples) == o.samples.end()) continue;
      Ratio ratio = columns::ratio(mine, base, i);
      ratio.sampler = sampler;
      if (!first.comparable() || !other.comparable()) {
        ratio.equal_time = ratio.equal_error_time = {NAN, NAN, NAN};
      }
      result.ratios.push_back(ratio);
    }
  }
  return result;
}

}  // namespace

const Ratio* Overlay::ratio(const Beside& b, const std::string& sampler, std::uint32_t count) const {
  for (const Ratio& r : b.ratios) {
    if (r.sampler == sampler && r.samples == count) return &r;
  }
  return nullptr;
}

Overlay make_overlay(std::vector<KeptStudy> studies, std::vector<std::string> labels,
                     std::vector<std::string> samplers) {
  for (std::size_t i = 1; i < studies.size(); ++i) check_same(studies[0], studies[i]);
  if (!labels.empty() && labels.size() != studies.size()) {
    throw InputError(
        fmt::format("there are {} labels for {} studies; give one for each", labels.size(), studies.size()));
  }
  Overlay o;
  o.labels = labels.empty() ? names_of(studies) : std::move(labels);
  if (std::set<std::string>(o.labels.begin(), o.labels.end()).size() != o.labels.size())
    throw InputError("two studies have the same label; give each its own with --label");
  o.samplers = common(studies, &StudySettings::samplers);
  for (const std::string& sampler : samplers) {
    if (std::find(o.samplers.begin(), o.samplers.end(), sampler) == o.samplers.end())
      throw InputError(fmt::format("{} was not measured in all of these studies; {} {}", sampler,
                                   enumerate(o.samplers), o.samplers.size() == 1 ? "was" : "were"));
  }
  if (o.samplers.empty()) throw InputError("these studies have no sampler in common");
  if (!samplers.empty()) o.samplers = std::move(samplers);
  o.samples = common(studies, &StudySettings::samples);
  if (o.samples.empty()) {
    throw InputError(fmt::format("these studies have no number of {} in common",
                                 words_of(studies[0].result.settings.integral).many));
  }
  o.seeds = studies[0].result.settings.seeds;
  for (const KeptStudy& study : studies) {
    o.seeds = std::min(o.seeds, study.result.settings.seeds);
    o.figures.push_back(make_figures(study.result));
  }
  o.studies = std::move(studies);
  for (std::size_t k = 1; k < o.studies.size(); ++k) o.beside.push_back(beside(o, k));
  return o;
}

std::vector<Difference> differences(const Overlay& overlay) {
  std::map<std::string, Difference> found;  // by rank and name
  const auto add = [&](const std::string& rank, const std::string& name, std::size_t study,
                       const json& value) {
    Difference& d = found.try_emplace(rank + name, Difference{name, {}}).first->second;
    d.values.resize(overlay.studies.size(), "–");
    d.values[study] = value.is_string() ? value.get<std::string>() : value.dump();
  };
  for (std::size_t i = 0; i < overlay.studies.size(); ++i) {
    const StudyResult& r = overlay.studies[i].result;
    for (const auto& [name, value] : r.device.items()) add("0", "device " + name, i, value);
    add("1", "capcon", i, r.version);
    add("1", "first measured", i, r.started);
    const json settings = to_json(r.settings);
    for (const auto& [name, value] : settings.items()) {
      static const std::map<std::string, std::string> kNames = {
          {"points_fingerprint", "what the samplers make"},
          {"reference_samples", "samples of each reference group"},
          {"reference_groups", "reference groups"}};
      const auto known = kNames.find(name);
      if (name != "version")
        add(name == "command" ? "3" : "2", known == kNames.end() ? name : known->second, i, value);
    }
    add("2", "the reference’s own error", i, scientific(r.reference.error));
  }
  std::vector<Difference> result;
  for (auto& [key, d] : found) {
    if (std::any_of(d.values.begin(), d.values.end(), [&](const std::string& v) { return v != d.values[0]; }))
      result.push_back(std::move(d));
  }
  return result;
}

json to_json(const Overlay& o) {
  const auto number = [](double v) { return std::isfinite(v) ? json(v) : json(nullptr); };
  const auto interval = [&](const Interval& v) {
    return json{{"value", number(v.value)}, {"low", number(v.low)}, {"high", number(v.high)}};
  };
  json studies = json::array(), besides = json::array(), different = json::array();
  for (std::size_t i = 0; i < o.studies.size(); ++i) {
    studies.push_back({{"label", o.labels[i]}, {"study", to_json(o.studies[i].result, o.figures[i])}});
  }
  for (const Beside& b : o.beside) {
    json ratios = json::array();
    for (const Ratio& r : b.ratios) {
      ratios.push_back({{"sampler", r.sampler},
                        {"samples", r.samples},
                        {"mse_ratio", interval(r.mse)},
                        {"equal_error_samples", interval(r.equal_error)},
                        {"equal_error_beyond", r.beyond},
                        {"equal_error_time_ratio", interval(r.equal_error_time)},
                        {"equal_time_mse_ratio", interval(r.equal_time)}});
    }
    besides.push_back({{"label", o.labels[b.study]},
                       {"beside", o.labels[0]},
                       {"same_errors", b.same_errors},
                       {"ratios", ratios}});
  }
  for (const Difference& d : differences(o)) different.push_back({{"name", d.name}, {"values", d.values}});
  return {{"findings", make_findings(o)},
          {"seeds", o.seeds},
          {"differences", different},
          {"beside", besides},
          {"studies", studies}};
}

}  // namespace capcon
