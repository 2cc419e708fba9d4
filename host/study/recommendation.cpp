#include "study/recommendation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "study/columns.h"
#include "study/format.h"

namespace capcon {
namespace {

using columns::Kept;
using Columns = std::map<std::string, std::vector<Column>>;

const Column* column_at(const std::vector<Column>& all, std::uint32_t samples) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Column& c) { return c.samples == samples && c.sure; });
  return found == all.end() ? nullptr : &*found;
}

/// A sampler's MSE within the budget, for some of the seeds; NaN where it was never so short or long.
class Budget {
 public:
  Budget(const Column& base, bool by_time) : base_(base), by_time_(by_time) {}

  double mse(const std::vector<Column>& all) const {
    std::vector<std::size_t> seeds(base_.mse.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = i;
    return mse(all, seeds, false);
  }

  Interval ratio(const std::vector<Column>& a, const std::vector<Column>& b) const {
    return exp(jackknife(base_.mse.size(),
                         [&](Kept kept) { return std::log(mse(a, kept, true) / mse(b, kept, true)); }));
  }

 private:
  double mse(const std::vector<Column>& all, Kept kept, bool extrapolate) const {
    if (!by_time_) {
      const Column* same = column_at(all, base_.samples);
      return same ? columns::geometric_mean_of(same->mse, kept) : NAN;
    }
    const columns::Path path = columns::path(all, kept);
    if (path.mse.size() < 2) return NAN;
    return log_log_interpolate(path.device, path.mse, columns::geometric_mean_of(base_.device, kept),
                               extrapolate);
  }

  const Column& base_;
  bool by_time_;
};

/// A variant with more points than others at its count.
bool unfair(const std::string& name, bool by_time, const StudySettings& settings) {
  return !by_time && has_variants(settings.integral) && parse_variant(name).factor > 1;
}

/// The sampler that errs least in the budget of `base`, and of how many.
Recommendation lowest_at(const Column& base, bool by_time, const StudySettings& settings,
                         const Columns& columns) {
  const Budget budget(base, by_time);
  Recommendation r;
  double lowest = INFINITY;
  for (const std::string& name : settings.samplers) {
    const double mse = budget.mse(columns.at(name));
    if (std::isnan(mse) || unfair(name, by_time, settings)) continue;
    ++r.compared;
    if (mse < lowest) lowest = mse, r.sampler = name;
  }
  return r;
}

std::string baseline_of(const Columns& columns, const StudySettings& settings) {
  for (const char* name : {"sobol-owen", "sobol-xor"}) {
    if (columns.contains(name)) return name;
  }
  return settings.samplers.front();
}

std::string budget_words(const Recommendation& r, const StudySettings& settings) {
  if (settings.integral == Integral::splitting)
    return fmt::format("at {} (image samples x points)", count_label(settings, r.samples));
  const IntegralWords& words = words_of(settings.integral);
  const std::string count = fmt::format("{} {}", r.samples, r.samples == 1 ? words.one : words.many);
  return r.by_time ? fmt::format("in the device time of {} of {}", count, r.baseline)
                   : fmt::format("with {}", count);
}

}  // namespace

std::uint32_t spoken_count(const StudySettings& settings) {
  constexpr std::uint32_t kPreferred = 64;
  const auto& n = settings.samples;
  if (settings.integral == Integral::global_illumination || settings.integral == Integral::splitting)
    return n[n.size() / 2];
  return std::find(n.begin(), n.end(), kPreferred) != n.end() ? kPreferred : n.back();
}

std::optional<Recommendation> recommend(const StudySettings& settings, const Columns& columns,
                                        bool times_comparable) {
  if (columns.size() < 2) return std::nullopt;
  Recommendation r;
  r.baseline = baseline_of(columns, settings);
  r.by_time = times_comparable;
  const std::vector<Column>& baseline = columns.at(r.baseline);
  // As far as most samplers have a figure: what takes long may take longer than any render of the others.
  const std::uint32_t most = spoken_count(settings);
  for (auto c = baseline.rbegin(); c != baseline.rend(); ++c) {
    if (!c->sure || c->samples > most) continue;
    const Recommendation at = lowest_at(*c, r.by_time, settings, columns);
    if (at.compared <= r.compared) continue;
    r.samples = c->samples;
    r.sampler = at.sampler;
    r.compared = at.compared;
  }
  if (r.compared < 2) return std::nullopt;
  const Budget budget(*column_at(baseline, r.samples), r.by_time);
  const Budget samples(*column_at(baseline, r.samples), false);
  const std::vector<Column>& best = columns.at(r.sampler);
  r.error = budget.ratio(best, baseline);
  for (const std::string& name : settings.samplers) {
    if (name == r.sampler || unfair(name, r.by_time, settings) || std::isnan(budget.mse(columns.at(name))))
      continue;
    if (budget.ratio(columns.at(name), best).above(1)) continue;
    r.undecided.push_back(name);
    const Interval by_samples = samples.ratio(columns.at(name), best);
    if (!by_samples.above(1)) r.undecided_by_samples.push_back(name);
  }
  return r;
}

std::string sentence(const Recommendation& r, const StudySettings& settings, const Figures& figures) {
  const std::string budget = budget_words(r, settings);
  std::string error, need;
  if (r.sampler != r.baseline) {
    error = fmt::format(", {} times that of {}", with_range(r.error), r.baseline);
    const Ratio* ratio = figures.ratio(r.sampler, r.baseline, r.samples);
    if (ratio && !std::isnan(ratio->equal_error.value) && settings.integral != Integral::splitting) {
      need = fmt::format(" It comes to the error of these {} with {} {}", r.samples,
                         with_range(ratio->equal_error), words_of(settings.integral).many);
      if (r.by_time && !std::isnan(ratio->equal_error_time.value))
        need += fmt::format(", in {} of their time", with_range(ratio->equal_error_time));
      need += '.';
    }
  }
  if (settings.seeds < 2) {
    return fmt::format("{0} has the lowest error here {1}{2}. One seed does not say how sure that is.{3}",
                       r.sampler, budget, error, need);
  }
  if (r.undecided.empty()) {
    return fmt::format(
        "Use {} here: {} it has the lowest error of {} samplers{}; each of the others is shown to err "
        "more.{}",
        r.sampler, budget, r.compared, error, need);
  }
  if (r.by_time && r.undecided_by_samples.empty())
    need = fmt::format(" With as many {} each of the others is shown to err more.",
                       words_of(settings.integral).many) +
           need;
  if (r.undecided.size() + 1 == r.compared) {
    return fmt::format(
        "No sampler is shown to be the best here: {} {} has the lowest error{}, but {} seeds do not show "
        "that any "
        "of the others errs more.{}",
        budget, r.sampler, error, settings.seeds, need);
  }
  return fmt::format("{} has the lowest error here {}{}, but {} seeds do not show that {} {} more.{}",
                     r.sampler, budget, error, settings.seeds, enumerate(r.undecided),
                     r.undecided.size() == 1 ? "errs" : "err", need);
}

nlohmann::json to_json(const Recommendation& r) {
  const auto number = [](double v) { return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json(nullptr); };
  return {{"sampler", r.sampler},
          {"baseline", r.baseline},
          {"samples", r.samples},
          {"at_equal", r.by_time ? "device time" : "samples"},
          {"mse_ratio",
           {{"value", number(r.error.value)}, {"low", number(r.error.low)}, {"high", number(r.error.high)}}},
          {"compared", r.compared},
          {"undecided", r.undecided},
          {"undecided_with_as_many_samples", r.undecided_by_samples}};
}

}  // namespace capcon
