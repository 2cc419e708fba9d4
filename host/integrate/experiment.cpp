#include "integrate/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "integrate/costs.h"
#include "integrate/trials.h"
#include "sampling/point_file.h"

namespace capcon::integrate {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Trials whose star discrepancy is computed, at n^2 steps each.
std::uint32_t discrepancy_trials(std::uint32_t n) {
  return n > 16384 ? 0 : std::clamp(8192 / n, 2u, 8u);
}

/// What one trial of one (integrand, estimator) gives.
struct Outcome {
  double error = kNone, bound = kNone, energy_part = kNone;
};

Bound::Kind kind_of(const Estimator& estimator) {
  if (estimator.weights == Weights::areas) return Bound::Kind::second_derivative;
  if (estimator.method == "random") return Bound::Kind::three_sigma;
  return Bound::Kind::koksma_hlawka;
}

/// Everything of one integrand that does not depend on the points.
struct Problem {
  const Integrand& integrand;
  std::vector<Draw> draws;  ///< a trial each, or one for all
  const Draw& draw(std::size_t trial) const { return draws[draws.size() == 1 ? 0 : trial]; }
};

std::vector<Problem> make_problems(const Settings& settings) {
  std::vector<Problem> problems;
  for (const std::string& name : settings.integrands) {
    Problem problem{find_integrand(name), {}};
    problem.draws.resize(problem.integrand.family ? settings.randomisations : 1);
    parallel_for(
        problem.draws.size(),
        [&](std::size_t t) { problem.draws[t] = problem.integrand.draw(settings.seed, t); }, 64);
    problems.push_back(std::move(problem));
  }
  return problems;
}

/// Why there is no bound, or nothing.
std::string missing_bound(const Problem& problem, const Estimator& estimator, std::uint32_t n) {
  const Draw& draw = problem.draws.front();
  switch (kind_of(estimator)) {
    case Bound::Kind::second_derivative:
      return draw.smooth ? "" : "f is not twice differentiable";
    case Bound::Kind::koksma_hlawka:
      if (!draw.variation) return problem.integrand.variation_note;
      return discrepancy_trials(n) > 0 ? "" : "the discrepancy of so many points takes too long";
    default:
      return {};
  }
}

Outcome run_trial(const Problem& problem, const Estimator& estimator, TrialPoints& points,
                  std::size_t trial) {
  const Draw& draw = problem.draw(trial);
  Outcome outcome;
  outcome.error = points.estimate(problem.integrand, draw, estimator.weights) - draw.integral;
  const auto n = static_cast<std::uint32_t>(points.points().size());
  switch (kind_of(estimator)) {
    case Bound::Kind::second_derivative:
      if (draw.smooth) {
        const CellSums& cells = points.cells(problem.integrand.domain);
        outcome.bound = second_derivative_bound(cells, draw.smooth->gradient, draw.smooth->hessian);
        outcome.energy_part = second_derivative_bound({{}, cells.energy, 0}, 0, draw.smooth->hessian);
      }
      break;
    case Bound::Kind::koksma_hlawka:
      if (draw.variation && trial < discrepancy_trials(n))
        outcome.bound = *draw.variation * points.discrepancy();
      break;
    default: {
      const double sigma =
          estimator.weights == Weights::importance ? problem.integrand.importance->sigma : draw.sigma;
      outcome.bound = 3 * sigma / std::sqrt(static_cast<double>(n));
    }
  }
  return outcome;
}

/// Rounding: a bound that is met exactly is not exceeded.
bool exceeds(double error, double bound) {
  return std::abs(error) > bound * (1 + 1e-9) + 1e-12;
}

Sample collect(const std::vector<Outcome>& outcomes, std::size_t first, std::size_t stride) {
  Sample sample;
  for (std::size_t at = first; at < outcomes.size(); at += stride) {
    const Outcome& outcome = outcomes[at];
    sample.errors.push_back(outcome.error);
    if (std::isnan(outcome.bound)) continue;
    sample.bound.mean += outcome.bound;
    sample.bound.energy_part += outcome.energy_part;
    sample.bound.exceeded += exceeds(outcome.error, outcome.bound) ? 1 : 0;
    ++sample.bound.checked;
  }
  if (sample.bound.checked > 0) {
    sample.bound.mean /= sample.bound.checked;
    sample.bound.energy_part /= sample.bound.checked;
  }
  return sample;
}

/// Files of points get the names that tables can hold; that one has too few is told before the work.
void name_point_files(Settings& settings) {
  const std::vector<std::string> labels = sampler_labels(settings.estimators);
  for (std::size_t e = 0; e < labels.size(); ++e) {
    if (!is_point_file(settings.estimators[e])) continue;
    for (const std::uint32_t n : settings.counts) make_sampler(settings.estimators[e], n, 1);
    settings.point_files[labels[e]] = settings.estimators[e];
  }
  settings.estimators = labels;
}

Settings completed(Settings settings) {
  if (settings.randomisations < 2)
    throw InputError("an error needs at least 2 randomisations to be measured");
  if (settings.counts.empty()) throw InputError("name at least one number of points (-n)");
  if (settings.integrands.empty()) {
    for (const Integrand& integrand : battery()) settings.integrands.push_back(integrand.name);
  }
  if (settings.estimators.empty()) {
    for (const Estimator& estimator : estimators()) settings.estimators.push_back(estimator.name);
  }
  const auto check = [](std::vector<std::string> names, const char* option) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) throw InputError(fmt::format("{} names {} twice", option, *twice));
  };
  check(settings.integrands, "--integrands");
  check(settings.estimators, "--estimators");
  for (const std::string& name : settings.integrands) find_integrand(name);
  name_point_files(settings);
  for (const std::string& name : settings.estimators) find_estimator(name, settings.point_files);
  return settings;
}

/// Estimators that share their points.
struct Group {
  std::string method;
  std::vector<std::size_t> members;
};

std::vector<Group> group_by_method(const Settings& settings) {
  std::vector<Group> groups;
  for (std::size_t e = 0; e < settings.estimators.size(); ++e) {
    const std::string& method = find_estimator(settings.estimators[e], settings.point_files).method;
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.method == method; });
    if (group == groups.end()) group = groups.insert(groups.end(), {method, {}});
    group->members.push_back(e);
  }
  return groups;
}

bool applies(const Estimator& estimator, const Integrand& integrand) {
  return estimator.weights != Weights::importance || integrand.importance.has_value();
}

}  // namespace

std::uint32_t trials_at(const Settings& settings, std::uint32_t n) {
  if (n <= kFullCount) return settings.randomisations;
  const std::uint64_t fewer = static_cast<std::uint64_t>(settings.randomisations) * kFullCount / n;
  return static_cast<std::uint32_t>(std::max<std::uint64_t>(fewer, 2));
}

Experiment run_experiment(Settings wanted) {
  const auto start = std::chrono::steady_clock::now();
  Experiment experiment{completed(std::move(wanted)), {}, {}, 0};
  const Settings& settings = experiment.settings;
  const std::vector<Problem> problems = make_problems(settings);
  const std::vector<Group> groups = group_by_method(settings);
  std::vector<Estimator> chosen;
  for (const std::string& name : settings.estimators)
    chosen.push_back(find_estimator(name, settings.point_files));
  experiment.samples.resize(problems.size() * settings.estimators.size() * settings.counts.size());
  experiment.costs.resize(experiment.samples.size());
  Progress progress("integrate", static_cast<double>(groups.size() * settings.counts.size()), settings.quiet);
  double done = 0;
  for (const Group& group : groups) {
    for (std::size_t c = 0; c < settings.counts.size(); ++c) {
      const std::uint32_t n = settings.counts[c];
      progress.update(done++, fmt::format("{} n = {}", group.method, n));
      const auto source = make_source(group.method, n, settings.seed);
      const std::size_t width = problems.size() * group.members.size();
      std::vector<Outcome> outcomes(trials_at(settings, n) * width);
      parallel_for(
          trials_at(settings, n),
          [&](std::size_t trial) {
            TrialPoints points(*source, trial);
            for (std::size_t k = 0; k < width; ++k) {
              const Problem& problem = problems[k / group.members.size()];
              const Estimator& estimator = chosen[group.members[k % group.members.size()]];
              if (applies(estimator, problem.integrand))
                outcomes[trial * width + k] = run_trial(problem, estimator, points, trial);
            }
          },
          4);
      CostMeter meter(*source);
      for (std::size_t k = 0; k < width; ++k) {
        const Problem& problem = problems[k / group.members.size()];
        const std::size_t e = group.members[k % group.members.size()];
        const Estimator& estimator = chosen[e];
        const std::size_t at = experiment.index(k / group.members.size(), e, c);
        if (!applies(estimator, problem.integrand)) {
          experiment.samples[at].bound.missing = problem.integrand.no_importance;
          continue;
        }
        experiment.samples[at] = collect(outcomes, k, width);
        Bound& bound = experiment.samples[at].bound;
        bound.missing = missing_bound(problem, estimator, n);
        bound.kind = bound.missing.empty() ? kind_of(estimator) : Bound::Kind::none;
        experiment.costs[at] = meter.cost(problem.integrand, problem.draws.front(), estimator.weights);
      }
    }
  }
  experiment.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return experiment;
}

}  // namespace capcon::integrate
