#include "study/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/format.h"
#include "study/igi_findings.h"
#include "study/split_findings.h"

namespace capcon {
namespace {

std::string needed(const Ratio& ratio, const StudySettings& settings) {
  if (ratio.beyond < 0) return fmt::format("fewer than {}", settings.samples.front());
  if (ratio.beyond > 0) return fmt::format("more than {}", settings.samples.back());
  return with_range(ratio.equal_error);
}

std::string headline(const StudySettings& settings, const Figures& figures, const std::string& subject) {
  const std::uint32_t n = spoken_count(settings);
  std::vector<std::string> parts;
  for (const std::string& baseline : figures.baselines) {
    const Ratio* r = figures.ratio(subject, baseline, n);
    if (!r || (r->beyond == 0 && std::isnan(r->equal_error.value))) continue;
    parts.push_back(fmt::format("{}{} for the error of {} {} samples", needed(*r, settings),
                                parts.empty() ? " samples" : "", n, baseline));
  }
  if (parts.empty()) return fmt::format("{} samplers compared.", settings.samplers.size());
  return fmt::format("{} needs {}.", subject, enumerate(parts));
}

/// "2, 8 to 64": three and more neighbours of the study's list are drawn together.
std::string counts_text(const StudySettings& settings, const std::vector<std::uint32_t>& counts) {
  std::vector<std::string> words;
  const auto place = [&](std::uint32_t n) {
    return std::find(settings.samples.begin(), settings.samples.end(), n) - settings.samples.begin();
  };
  for (std::size_t i = 0; i < counts.size();) {
    std::size_t last = i;
    while (last + 1 < counts.size() && place(counts[last + 1]) == place(counts[last]) + 1) ++last;
    if (last >= i + 2) {
      words.push_back(fmt::format("{} to {}", counts[i], counts[last]));
      i = last + 1;
    } else {
      words.push_back(fmt::format("{}", counts[i++]));
    }
  }
  return enumerate(words) + (counts.back() == 1 ? " sample" : " samples");
}

/// "With as many samples, capcon errs less than sobol-xor at 8 to 64 samples and more at 1 sample; ..."
std::string equal_samples(const StudySettings& settings, const Figures& figures, const std::string& subject,
                          const std::string& baseline) {
  if (settings.seeds < 2) return {};  // no interval, so no difference can be shown
  std::vector<std::uint32_t> less, more, open;
  for (const std::uint32_t n : settings.samples) {
    const Ratio* r = figures.ratio(subject, baseline, n);
    if (!r || std::isnan(r->mse.value)) continue;
    (r->mse.below(1) ? less : r->mse.above(1) ? more : open).push_back(n);
  }
  std::string text;
  if (!less.empty()) text += fmt::format("errs less than {} at {}", baseline, counts_text(settings, less));
  if (!more.empty()) {
    text += less.empty() ? fmt::format("errs more than {} at {}", baseline, counts_text(settings, more))
                         : fmt::format(", more at {}", counts_text(settings, more));
  }
  if (!open.empty()) {
    text += text.empty()
                ? fmt::format("is not shown to differ from {} at {}", baseline, counts_text(settings, open))
                : fmt::format("; no difference is shown at {}", counts_text(settings, open));
  }
  return text.empty() ? text : fmt::format("With as many samples, {} {}.", subject, text);
}

std::string best(const StudySettings& settings, const Figures& figures) {
  std::vector<std::string> parts;
  for (const std::uint32_t n : {16u, settings.samples.back()}) {
    const Curve* lowest = nullptr;
    for (const Curve& curve : figures.curves) {
      const Cell* cell = find_cell(curve, n);
      if (!cell || !cell->sure) continue;
      if (!lowest || cell->mse.value < find_cell(*lowest, n)->mse.value) lowest = &curve;
    }
    if (!lowest) continue;
    std::string text =
        fmt::format("at {} samples {} ({}", n, lowest->sampler, scientific(find_cell(*lowest, n)->mse.value));
    const Ratio* r = figures.ratio(lowest->sampler, "sobol-owen", n);
    if (r && !std::isnan(r->mse.value)) text += fmt::format(", {} times sobol-owen's", with_range(r->mse));
    parts.push_back(text + ")");
    if (n == settings.samples.back()) break;
  }
  return parts.empty() ? "" : fmt::format("Lowest error of all: {}.", enumerate(parts));
}

/// The text's figure 5.20: lower MSE than sobol-xor from more than four samples on; 32 as good as 64 in
/// places.
std::string beside_the_text(const StudySettings& settings, const Figures& figures) {
  const std::string subject = "capcon";
  if (settings.seeds < 2) return {};
  if (settings.integral == Integral::direct) {
    const Ratio* r = figures.ratio(subject, "sobol-xor", 16);
    if (!r || std::isnan(r->mse.value)) return {};
    return fmt::format(
        "The text this follows (figure 5.18, its own scene, 16 samples) has 0.8e-3 for its points and 1.5e-3 "
        "for the "
        "(0,2)-sequence, a ratio of 0.53: here capcon beside sobol-xor has {}.",
        with_range(r->mse));
  }
  int lower = 0;
  int counted = 0;
  for (const std::uint32_t n : settings.samples) {
    const Ratio* r = figures.ratio(subject, "sobol-xor", n);
    if (n <= 4 || !r || std::isnan(r->mse.value)) continue;
    ++counted;
    lower += r->mse.below(1) ? 1 : 0;
  }
  if (counted == 0) return {};
  std::string text = fmt::format(
      "The text this follows (figure 5.20) saw a lower error with corner tiles than with sobol-xor from more "
      "than four samples on: here capcon has it at {} of {} such counts.",
      lower, counted);
  const Ratio* r = figures.ratio(subject, "sobol-xor", 64);
  if (r && (r->beyond != 0 || !std::isnan(r->equal_error.value))) {
    text += fmt::format(
        " It saw 32 of its points look about as good as 64 in places: here 64 are matched, by MSE, by {} of "
        "capcon.",
        needed(*r, settings));
  }
  return text;
}

std::string equal_time(const StudySettings& settings, const Figures& figures, const std::string& subject) {
  const std::uint32_t n = spoken_count(settings);
  std::vector<std::string> parts;
  for (const std::string& baseline : figures.baselines) {
    const Ratio* r = figures.ratio(subject, baseline, n);
    if (r && !std::isnan(r->equal_time.value)) {
      parts.push_back(fmt::format("{} times that of {}", with_range(r->equal_time), baseline));
    }
  }
  if (parts.empty()) return {};
  return fmt::format("In the device time that {} samples of the baseline take, {}'s error is {}.", n, subject,
                     enumerate(parts));
}

std::string unsure(const StudySettings& settings, const Figures& figures) {
  int count = 0;
  for (const Curve& curve : figures.curves) {
    for (const Cell& cell : curve.cells) count += cell.sure ? 0 : 1;
  }
  if (count == 0) return {};
  return fmt::format(
      "{} of the measured errors {} less than {} times the reference image's own error and {} left out of "
      "all "
      "comparisons; more --reference-{} would settle {}.",
      count, count == 1 ? "is" : "are", kReferenceMargin, count == 1 ? "is" : "are",
      words_of(settings.integral).many, count == 1 ? "it" : "them");
}

}  // namespace

std::string study_subject(const StudySettings& settings) {
  const auto& names = settings.samplers;
  // The text's own points are what a study of light paths asks about first.
  if (settings.integral == Integral::global_illumination &&
      std::find(names.begin(), names.end(), "capcon") != names.end())
    return "capcon";
  for (const char* ours : {"capcon-domain", "capcon"}) {
    if (std::find(names.begin(), names.end(), ours) != names.end()) return ours;
  }
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    if (!name->starts_with("sobol")) return *name;
  }
  return names.back();
}

std::vector<std::string> make_findings(const StudySettings& settings, const Figures& figures) {
  const std::string subject = study_subject(settings);
  std::vector<std::string> findings;
  const auto add = [&](std::string sentence) {
    if (!sentence.empty()) findings.push_back(std::move(sentence));
  };
  if (settings.integral == Integral::splitting) {
    if (figures.recommendation) add(sentence(*figures.recommendation, settings, figures));
    for (std::string& finding : make_split_findings(settings, figures)) add(std::move(finding));
    return findings;
  }
  const auto add_doubts = [&] {
    add(unsure(settings, figures));
    if (settings.seeds < 2) add("There was one seed only: nothing here says how sure the figures are.");
  };
  if (figures.recommendation) add(sentence(*figures.recommendation, settings, figures));
  if (settings.integral == Integral::global_illumination) {
    for (std::string& finding : make_igi_findings(settings, figures)) add(std::move(finding));
    add_doubts();
    return findings;
  }
  add(headline(settings, figures, subject));
  for (const std::string& baseline : figures.baselines) {
    if (baseline != subject) add(equal_samples(settings, figures, subject, baseline));
  }
  add(equal_time(settings, figures, subject));
  add(best(settings, figures));
  add(beside_the_text(settings, figures));
  add_doubts();
  return findings;
}

}  // namespace capcon
