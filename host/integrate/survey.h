#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "integrate/analysis.h"

namespace capcon::integrate {

/// Questions that findings and tables put to a finished experiment.
class Survey {
 public:
  Survey(const Experiment& experiment, const Analysis& analysis);

  const Settings& settings() const { return experiment_.settings; }
  /// The count that sentences speak of: the last of spoken_counts.
  std::size_t count() const { return count_; }
  std::uint32_t n() const { return settings().counts[count_]; }

  std::optional<std::size_t> estimator(const std::string& name) const;
  /// Integrands that jump, or those that do not.
  std::vector<std::size_t> integrands(bool edges) const;
  std::optional<std::size_t> integrand(const std::string& name) const;

  const Sample& sample(std::size_t integrand, std::size_t estimator) const;
  const Figure& figure(std::size_t integrand, std::size_t estimator) const;
  const Interval& slope(std::size_t integrand, std::size_t estimator) const;

  /// Geometric mean over integrands of MSE / that of a baseline, at count(). NaN if one of them is missing or
  /// exact.
  double mean_ratio(const std::vector<std::size_t>& integrands, std::size_t estimator,
                    std::size_t baseline) const;
  /// Bounds of a kind, over everything that was measured.
  struct Tally {
    std::uint64_t checked = 0, exceeded = 0;
    std::vector<double> slack;  ///< bound / RMSE at count()
  };
  Tally tally(Bound::Kind kind) const;

 private:
  const Experiment& experiment_;
  const Analysis& analysis_;
  std::size_t count_;
};

}  // namespace capcon::integrate
