#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace capcon {

/// An estimate with its confidence interval. Unknown ends are NaN (one observation gives no interval).
struct Interval {
  double value = 0;
  double low = 0;
  double high = 0;

  /// The interval lies wholly below or wholly above `x`: the data show a difference.
  bool below(double x) const { return high < x; }
  bool above(double x) const { return low > x; }
};

inline constexpr double kConfidence = 0.95;

double mean(std::span<const double> values);
/// Sample standard deviation, divisor n - 1; NaN for fewer than two values.
double standard_deviation(std::span<const double> values);
/// exp(mean(log)): for positive values.
double geometric_mean(std::span<const double> values);

/// P(T <= t) of Student's t distribution with `freedom` >= 1 degrees: the finite sums for integer degrees,
/// Abramowitz and Stegun 26.7.3 and 26.7.4.
double student_t_cdf(double t, unsigned freedom);
/// The t with P(T <= t) = p, 0 < p < 1.
double student_t_quantile(double p, unsigned freedom);

/// mean +- t(n - 1) s / sqrt(n).
Interval mean_interval(std::span<const double> values, double confidence = kConfidence);
/// The same on logarithms, turned back: the geometric mean with an interval that is symmetric as a factor.
Interval geometric_mean_interval(std::span<const double> values, double confidence = kConfidence);
/// exp of the value and of both ends.
Interval exp(const Interval& logarithm);

/// Slope of the least-squares line through (log x, log y); NaN for fewer than two different x.
double log_log_slope(std::span<const double> x, std::span<const double> y);

/// y at `at` on the piecewise straight line through the points in log-log space, of which there may be
/// several where x turns back: then the last. Outside all pieces: NaN, or with `extrapolate` the nearer end
/// piece continued.
double log_log_interpolate(std::span<const double> x, std::span<const double> y, double at,
                           bool extrapolate = false);

/// A statistic of `count` independent observations with its interval by the jackknife (Quenouille 1956, Tukey
/// 1958): value +- t(count - 1) se, se^2 = (count-1)/count sum_i (theta_i - mean theta)^2, theta_i without
/// observation i. For a mean this is exactly mean_interval; for smooth functions of means it is the delta
/// method. With the eight or so seeds of a study it covers better than percentile bootstraps, which are too
/// narrow there, and it needs no dice. `statistic` receives the indices of the observations to use.
Interval jackknife(std::size_t count, const std::function<double(std::span<const std::size_t>)>& statistic,
                   double confidence = kConfidence);

}  // namespace capcon
