#include "integrate/survey.h"

#include <algorithm>
#include <cmath>

#include "integrate/columns.h"

namespace capcon::integrate {
namespace {

std::optional<std::size_t> place(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

Survey::Survey(const Experiment& experiment, const Analysis& analysis)
    : experiment_(experiment), analysis_(analysis), count_(spoken_counts(experiment.settings).back()) {}

std::optional<std::size_t> Survey::estimator(const std::string& name) const {
  return place(settings().estimators, name);
}
std::optional<std::size_t> Survey::integrand(const std::string& name) const {
  return place(settings().integrands, name);
}

std::vector<std::size_t> Survey::integrands(bool edges) const {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < settings().integrands.size(); ++i) {
    if (find_integrand(settings().integrands[i]).edges == edges) chosen.push_back(i);
  }
  return chosen;
}

const Sample& Survey::sample(std::size_t integrand, std::size_t estimator) const {
  return experiment_.samples[experiment_.index(integrand, estimator, count_)];
}

const Figure& Survey::figure(std::size_t integrand, std::size_t estimator) const {
  return analysis_.figures[experiment_.index(integrand, estimator, count_)];
}

const Interval& Survey::slope(std::size_t integrand, std::size_t estimator) const {
  return analysis_.laws[integrand * settings().estimators.size() + estimator].slope;
}

double Survey::mean_ratio(const std::vector<std::size_t>& integrands, std::size_t estimator,
                          std::size_t baseline) const {
  double sum = 0;
  for (const std::size_t i : integrands) {
    const Figure &figure = this->figure(i, estimator), &other = this->figure(i, baseline);
    if (!figure.measured || !other.measured || figure.exact || other.exact) return NAN;
    sum += 2 * std::log(figure.rmse.value / other.rmse.value);
  }
  return integrands.empty() ? NAN : std::exp(sum / static_cast<double>(integrands.size()));
}

Survey::Tally Survey::tally(Bound::Kind kind) const {
  Tally tally;
  for (std::size_t i = 0; i < settings().integrands.size(); ++i) {
    for (std::size_t e = 0; e < settings().estimators.size(); ++e) {
      for (std::size_t c = 0; c < settings().counts.size(); ++c) {
        const std::size_t at = experiment_.index(i, e, c);
        const Bound& bound = experiment_.samples[at].bound;
        if (bound.kind != kind) continue;
        tally.checked += bound.checked;
        tally.exceeded += bound.exceeded;
        if (c == count_ && !analysis_.figures[at].exact)
          tally.slack.push_back(bound.mean / analysis_.figures[at].rmse.value);
      }
    }
  }
  std::sort(tally.slack.begin(), tally.slack.end());
  return tally;
}

}  // namespace capcon::integrate
