#include "base/statistics.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace capcon {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> result(values.begin(), values.end());
  for (double& v : result) v = std::log(v);
  return result;
}

/// value +- t(freedom) error.
Interval around(double value, double error, std::size_t observations, double confidence) {
  if (observations < 2) return {value, kUnknown, kUnknown};
  const double t = student_t_quantile(0.5 + confidence / 2, static_cast<unsigned>(observations - 1));
  return {value, value - t * error, value + t * error};
}

}  // namespace

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(std::span<const double> values) {
  if (values.size() < 2) return kUnknown;
  const double centre = mean(values);
  double sum = 0;
  for (const double v : values) sum += (v - centre) * (v - centre);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double geometric_mean(std::span<const double> values) {
  return std::exp(mean(logarithms(values)));
}

double student_t_cdf(double t, unsigned freedom) {
  assert(freedom >= 1);
  const double theta = std::atan(t / std::sqrt(static_cast<double>(freedom)));
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  // Both sums run over cos^k with the same kind of factors; they start at cos (odd degrees) or at 1 (even
  // ones).
  const bool odd = freedom % 2 == 1;
  double term = odd ? c : 1;
  double sum = freedom == 1 ? 0 : term;
  for (unsigned k = odd ? 3 : 2; k + 1 < freedom; k += 2) {
    term *= c * c * (k - 1) / k;
    sum += term;
  }
  const double within = odd ? 2 / std::numbers::pi * (theta + s * sum) : s * sum;  // P(-t < T < t), signed
  return 0.5 + within / 2;
}

double student_t_quantile(double p, unsigned freedom) {
  assert(p > 0 && p < 1);
  if (p == 0.5) return 0;
  if (p < 0.5) return -student_t_quantile(1 - p, freedom);
  double low = 0;
  double high = 1;
  while (student_t_cdf(high, freedom) < p && high < 1e15) high *= 2;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (student_t_cdf(middle, freedom) < p ? low : high) = middle;
  }
  return high;
}

Interval mean_interval(std::span<const double> values, double confidence) {
  const double error = standard_deviation(values) / std::sqrt(static_cast<double>(values.size()));
  return around(mean(values), error, values.size(), confidence);
}

Interval geometric_mean_interval(std::span<const double> values, double confidence) {
  return exp(mean_interval(logarithms(values), confidence));
}

Interval exp(const Interval& logarithm) {
  return {std::exp(logarithm.value), std::exp(logarithm.low), std::exp(logarithm.high)};
}

double log_log_slope(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  const std::vector<double> u = logarithms(x);
  const std::vector<double> v = logarithms(y);
  const double centre_u = mean(u);
  const double centre_v = mean(v);
  double square = 0;
  double product = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    square += (u[i] - centre_u) * (u[i] - centre_u);
    product += (u[i] - centre_u) * (v[i] - centre_v);
  }
  return square > 0 ? product / square : kUnknown;
}

double log_log_interpolate(std::span<const double> x, std::span<const double> y, double at,
                           bool extrapolate) {
  assert(x.size() == y.size());
  const auto on_piece = [&](std::size_t i) {  // the line through points i and i + 1
    const double span = std::log(x[i + 1] / x[i]);
    return span == 0 ? y[i + 1] : y[i] * std::pow(y[i + 1] / y[i], std::log(at / x[i]) / span);
  };
  if (x.empty()) return kUnknown;
  for (std::size_t i = x.size(); i-- > 0;) {
    if (x[i] == at) return y[i];
    if (i > 0 && (x[i - 1] - at) * (x[i] - at) < 0) return on_piece(i - 1);
  }
  if (!extrapolate || x.size() < 2) return kUnknown;
  const bool first = std::abs(std::log(at / x.front())) < std::abs(std::log(at / x.back()));
  return on_piece(first ? 0 : x.size() - 2);
}

Interval jackknife(std::size_t count, const std::function<double(std::span<const std::size_t>)>& statistic,
                   double confidence) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double value = statistic(all);
  if (count < 2) return around(value, kUnknown, count, confidence);
  std::vector<double> without;
  for (std::size_t left_out = 0; left_out < count; ++left_out) {
    std::vector<std::size_t> kept = all;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(left_out));
    without.push_back(statistic(kept));
  }
  // (count-1)/count times the sum of squares is (count-1)^2/count times the sample variance.
  const double n = static_cast<double>(count);
  return around(value, standard_deviation(without) * (n - 1) / std::sqrt(n), count, confidence);
}

}  // namespace capcon
