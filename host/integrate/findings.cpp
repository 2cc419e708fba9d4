#include "integrate/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "integrate/survey.h"
#include "study/format.h"

namespace capcon::integrate {
namespace {

std::string times(double ratio) {
  return ratio < 0.00995 || ratio >= 999.5 ? scientific(ratio) : short_number(ratio);
}

/// "ccvt-areas errs least on the 6 integrands with edges at n = 1024: ..."
std::string best(const Survey& survey, bool edges) {
  const auto random = survey.estimator("random"), owen = survey.estimator("sobol-owen");
  const auto integrands = survey.integrands(edges);
  if (!random || integrands.empty()) return {};
  std::optional<std::size_t> lowest;
  double value = INFINITY;
  for (std::size_t e = 0; e < survey.settings().estimators.size(); ++e) {
    const double ratio = survey.mean_ratio(integrands, e, *random);
    if (!(ratio < value)) continue;
    value = ratio;
    lowest = e;
  }
  if (!lowest || *lowest == *random) return {};
  std::string text = fmt::format(
      "On the {} integrands {} edges, {} errs least at n = {}: its MSE is {} times that of random points",
      integrands.size(), edges ? "with" : "without", survey.settings().estimators[*lowest], survey.n(),
      times(value));
  if (owen && *owen != *lowest)
    text +=
        fmt::format(" and {} times that of sobol-owen", times(survey.mean_ratio(integrands, *lowest, *owen)));
  return text + " (geometric means).";
}

/// "disk (0.64) and leaves (0.59)"; of many only how many and how far.
std::string list_of(const std::vector<std::pair<std::string, double>>& ratios, std::size_t all) {
  constexpr std::size_t kMost = 4;
  if (ratios.size() > kMost) {
    double low = INFINITY, high = 0;
    for (const auto& [name, ratio] : ratios) {
      low = std::min(low, ratio);
      high = std::max(high, ratio);
    }
    return fmt::format(
        "{} ({} to {})",
        ratios.size() == all ? fmt::format("all {}", all) : fmt::format("{} of {}", ratios.size(), all),
        times(low), times(high));
  }
  std::vector<std::string> words;
  for (const auto& [name, ratio] : ratios) words.push_back(fmt::format("{} ({})", name, times(ratio)));
  return enumerate(words);
}

/// "ccvt's MSE over sobol-owen's at n = 1024: below 1 on disk (0.64) ...; above on ...; no difference is
/// shown on ..."
std::string beside(const Survey& survey, const std::string& subject, const std::string& baseline) {
  const auto a = survey.estimator(subject), b = survey.estimator(baseline);
  if (!a || !b) return {};
  std::vector<std::pair<std::string, double>> less, more;
  std::vector<std::string> open;
  for (std::size_t i = 0; i < survey.settings().integrands.size(); ++i) {
    const Interval r = mse_ratio(survey.sample(i, *a), survey.sample(i, *b));
    const std::string& name = survey.settings().integrands[i];
    if (std::isnan(r.value)) continue;
    if (r.below(1)) {
      less.emplace_back(name, r.value);
    } else if (r.above(1)) {
      more.emplace_back(name, r.value);
    } else {
      open.push_back(name);
    }
  }
  const std::size_t all = less.size() + more.size() + open.size();
  std::vector<std::string> parts;
  if (!less.empty()) parts.push_back("below 1 on " + list_of(less, all));
  if (!more.empty()) parts.push_back("above 1 on " + list_of(more, all));
  if (!open.empty()) parts.push_back("no difference is shown on " + enumerate(open));
  if (parts.empty()) return {};
  std::string text = fmt::format("MSE of {} / MSE of {}, n = {}: ", subject, baseline, survey.n());
  for (std::size_t k = 0; k < parts.size(); ++k) text += (k > 0 ? "; " : "") + parts[k];
  return text + ".";
}

std::string monte_carlo(const Survey& survey) {
  const auto tally = survey.tally(Bound::Kind::three_sigma);
  if (tally.checked == 0) return {};
  return fmt::format(
      "Monte Carlo's 3σ/√n held in {} of {} trials, {:.4f}; a normal error would give 0.9973.",
      grouped(tally.checked - tally.exceeded), grouped(tally.checked),
      static_cast<double>(tally.checked - tally.exceeded) / static_cast<double>(tally.checked));
}

std::string theorem(const Survey& survey, Bound::Kind kind, const std::string& name) {
  const auto tally = survey.tally(kind);
  if (tally.checked == 0) return {};
  std::string text =
      fmt::format("{} was exceeded in {} of {} trials", name, tally.exceeded, grouped(tally.checked));
  if (!tally.slack.empty()) {
    text += fmt::format("; at n = {} it is {} times the RMSE in the median", survey.n(),
                        times(tally.slack[tally.slack.size() / 2]));
  }
  return text + ".";
}

/// "jittered −0.73 to −0.76": over the integrands of one kind.
std::string exponents(const Survey& survey, bool edges) {
  std::vector<std::string> words;
  for (const char* name :
       {"random", "random-areas", "jittered", "sobol-owen", "ccvt", "ccvt-areas", "capcon"}) {
    const auto e = survey.estimator(name);
    if (!e) continue;
    std::vector<double> values;
    for (const std::size_t i : survey.integrands(edges)) {
      if (std::isfinite(survey.slope(i, *e).value)) values.push_back(survey.slope(i, *e).value);
    }
    if (values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    words.push_back(fmt::format("{} −{:.2f} to −{:.2f}", name, -*high, -*low));
  }
  if (words.empty()) return {};
  return fmt::format("Exponents of n by which the RMSE falls, {} edges: {}.", edges ? "with" : "without",
                     enumerate(words));
}

std::string text_exponents(const Survey& survey) {
  if (!survey.estimator("random-areas")) return {};
  return "The text gives −0.5 for random points, and −1 for areas as weights where f is twice "
         "differentiable.";
}

/// Estimators whose mean error is not 0: random shifts and scramblings cannot show here.
std::string bias(const Survey& survey, const Experiment& experiment, const Analysis& analysis) {
  constexpr double kSure = 5;  // once in a million tests by chance
  std::vector<std::string> biased;
  std::uint64_t tests = 0;
  for (std::size_t e = 0; e < survey.settings().estimators.size(); ++e) {
    double farthest = 0;
    for (std::size_t i = 0; i < survey.settings().integrands.size(); ++i) {
      for (std::size_t c = 0; c < survey.settings().counts.size(); ++c) {
        const Figure& figure = analysis.figures[experiment.index(i, e, c)];
        if (!figure.measured || figure.exact) continue;
        ++tests;
        farthest = std::max(farthest, std::abs(figure.bias_z));
      }
    }
    if (farthest > kSure) biased.push_back(survey.settings().estimators[e]);
  }
  if (biased.empty())
    return fmt::format(
        "No estimator shows a bias: in none of {} samples is the mean error farther than {} standard errors "
        "from 0.",
        tests, kSure);
  return fmt::format(
      "{} {} biased: somewhere the mean error is more than {} standard errors from 0. (In the square, cells "
      "at the sides lean "
      "one way.) No other estimator is caught.",
      enumerate(biased), biased.size() == 1 ? "is" : "are", kSure);
}

std::string open_question(const Survey& survey, const std::vector<GeneratorEnergy>& plane) {
  const auto lowest = std::min_element(plane.begin(), plane.end(),
                                       [](const auto& a, const auto& b) { return a.energy < b.energy; });
  if (lowest == plane.end()) return {};
  std::string text = fmt::format(
      "Low energy and equal areas at once, at n = {}: {} comes nearest to hexagons, energy {:.4f} with area "
      "s.d. {:.4f}",
      kPlanePoints, lowest->method, lowest->energy, lowest->area_sd);
  const auto ccvt =
      std::find_if(plane.begin(), plane.end(), [](const auto& g) { return g.method == "ccvt"; });
  if (ccvt != plane.end() && ccvt != lowest)
    text += fmt::format("; ccvt has {:.4f} and {:.4f}", ccvt->energy, ccvt->area_sd);
  const auto e = survey.estimator(lowest->method), c = survey.estimator("ccvt");
  if (e && c && *e != *c) {
    const auto edges = survey.integrands(true);
    const double ratio = survey.mean_ratio(edges, *e, *c);
    if (std::isfinite(ratio)) {
      text += fmt::format(
          ". On edges its MSE under random shifts is {} times ccvt's (n = {}): the text's conjecture that "
          "other places gain little {}",
          times(ratio), survey.n(), ratio < 0.8 ? "does not hold for it there" : "agrees with that");
    }
  }
  return text + ".";
}

}  // namespace

std::vector<std::string> make_findings(const Experiment& experiment, const Analysis& analysis,
                                       const std::vector<GeneratorEnergy>& plane) {
  const Survey survey(experiment, analysis);
  std::vector<std::string> findings;
  for (std::string sentence :
       {best(survey, true), best(survey, false), beside(survey, "ccvt", "sobol-xor"),
        beside(survey, "ccvt", "sobol-owen"), beside(survey, "capcon", "ccvt"),
        beside(survey, "ccvt-areas", "ccvt"), beside(survey, "random-areas", "random"),
        exponents(survey, false), exponents(survey, true), text_exponents(survey), monte_carlo(survey),
        theorem(survey, Bound::Kind::koksma_hlawka, "Koksma and Hlawka's V·D*"),
        theorem(survey, Bound::Kind::second_derivative, "The second-derivative bound ½ME + GF"),
        bias(survey, experiment, analysis), open_question(survey, plane)}) {
    if (!sentence.empty()) findings.push_back(std::move(sentence));
  }
  return findings;
}

}  // namespace capcon::integrate
