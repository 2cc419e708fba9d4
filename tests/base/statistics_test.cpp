#include "base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/hash.h"

namespace capcon {
namespace {

/// A standard normal value by Box and Muller, addressed.
double normal(std::uint64_t seed, std::uint64_t counter) {
  const double u = 1 - uniform64(seed, 0, counter);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * uniform64(seed, 1, counter));
}

TEST(Statistics, StudentQuantilesArePublishedOnes) {
  // The usual table, two-sided 95 % and 99 %.
  EXPECT_NEAR(student_t_quantile(0.975, 1), 12.7062047, 1e-6);
  EXPECT_NEAR(student_t_quantile(0.975, 2), 4.30265273, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 3), 3.18244631, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 7), 2.36462425, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 10), 2.22813885, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 30), 2.04227246, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 120), 1.97993041, 1e-7);
  EXPECT_NEAR(student_t_quantile(0.995, 5), 4.03214298, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.95, 4), 2.13184679, 1e-8);
  EXPECT_NEAR(student_t_quantile(0.975, 100000), 1.95996398, 5e-5);  // the normal distribution
  EXPECT_NEAR(student_t_quantile(0.025, 7), -2.36462425, 1e-8);
  EXPECT_EQ(student_t_quantile(0.5, 7), 0);
}

TEST(Statistics, StudentCdfOfOneDegreeIsCauchys) {
  for (const double t : {-3.0, -0.5, 0.0, 0.25, 7.0}) {
    EXPECT_NEAR(student_t_cdf(t, 1), 0.5 + std::atan(t) / std::numbers::pi, 1e-15);
    EXPECT_NEAR(student_t_cdf(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)),
                1e-15);  // closed form of two degrees
  }
}

TEST(Statistics, MeanIntervalByHand) {
  const std::vector<double> values = {1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(mean(values), 2.5);
  EXPECT_DOUBLE_EQ(standard_deviation(values), std::sqrt(5.0 / 3));
  const Interval interval = mean_interval(values);
  EXPECT_NEAR(interval.high - 2.5, 3.18244631 * std::sqrt(5.0 / 3) / 2, 1e-7);
  EXPECT_NEAR(interval.high - 2.5, 2.5 - interval.low, 1e-14);
  EXPECT_TRUE(interval.below(5) && interval.above(0) && !interval.below(3) && !interval.above(2));
}

TEST(Statistics, OneValueHasNoInterval) {
  const std::vector<double> one = {3};
  EXPECT_EQ(mean_interval(one).value, 3);
  EXPECT_TRUE(std::isnan(mean_interval(one).low));
  const Interval by_jackknife = jackknife(1, [](auto) { return 3.0; });
  EXPECT_EQ(by_jackknife.value, 3);
  EXPECT_TRUE(std::isnan(by_jackknife.high));
  EXPECT_FALSE(by_jackknife.below(10));
}

TEST(Statistics, GeometricMeanIsAFactor) {
  const std::vector<double> values = {0.5, 2, 8};
  EXPECT_NEAR(geometric_mean(values), 2, 1e-15);
  const Interval interval = geometric_mean_interval(values);
  EXPECT_NEAR(interval.high / interval.value, interval.value / interval.low, 1e-9);
}

TEST(Statistics, JackknifeOfAMeanIsTheMeanInterval) {
  const std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6};
  const Interval direct = mean_interval(values);
  const Interval leave_one_out = jackknife(values.size(), [&](std::span<const std::size_t> kept) {
    double sum = 0;
    for (const std::size_t i : kept) sum += values[i];
    return sum / static_cast<double>(kept.size());
  });
  EXPECT_NEAR(leave_one_out.value, direct.value, 1e-14);
  EXPECT_NEAR(leave_one_out.low, direct.low, 1e-12);
  EXPECT_NEAR(leave_one_out.high, direct.high, 1e-12);
}

TEST(Statistics, JackknifeIntervalOfARatioCoversTheTruth) {
  // The ratio of two means (10 and 8, spread 10 %), eight observations: 95 % of 2,000 intervals hold 0.8.
  int covered = 0;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    const Interval interval = jackknife(8, [&](std::span<const std::size_t> kept) {
      double a = 0;
      double b = 0;
      for (const std::size_t i : kept) {
        a += 10 + normal(trial, 2 * i);
        b += 8 + 0.8 * normal(trial, 2 * i + 1);
      }
      return b / a;
    });
    covered += interval.low <= 0.8 && 0.8 <= interval.high ? 1 : 0;
  }
  EXPECT_NEAR(covered / 2000.0, 0.95, 0.015);  // three standard errors
}

TEST(Statistics, SlopeOfAPowerLaw) {
  const std::vector<double> x = {1, 2, 4, 8, 16};
  std::vector<double> y;
  for (const double v : x) y.push_back(3 * std::pow(v, -1.5));
  EXPECT_NEAR(log_log_slope(x, y), -1.5, 1e-14);
  EXPECT_TRUE(std::isnan(log_log_slope(std::vector<double>{2, 2}, std::vector<double>{1, 3})));
}

TEST(Statistics, InterpolationFollowsThePowerLaw) {
  const std::vector<double> x = {1, 4, 16};
  const std::vector<double> y = {1, 0.25, 0.0625};
  EXPECT_NEAR(log_log_interpolate(x, y, 2), 0.5, 1e-15);
  EXPECT_EQ(log_log_interpolate(x, y, 4), 0.25);
  EXPECT_EQ(log_log_interpolate(x, y, 16), 0.0625);
  EXPECT_TRUE(std::isnan(log_log_interpolate(x, y, 17)));
  EXPECT_NEAR(log_log_interpolate(x, y, 32, true), 1 / 32.0, 1e-15);
  EXPECT_NEAR(log_log_interpolate(x, y, 0.5, true), 2, 1e-14);
  EXPECT_NEAR(log_log_interpolate(y, x, 0.5), 2, 1e-14);  // a falling x works as well
  EXPECT_TRUE(std::isnan(log_log_interpolate({}, {}, 1)));
}

TEST(Statistics, InterpolationTakesTheLastCrossing) {
  const std::vector<double> x = {1, 4, 1, 4};
  const std::vector<double> y = {1, 2, 10, 40};
  EXPECT_NEAR(log_log_interpolate(x, y, 2), 20, 1e-12);
}

}  // namespace
}  // namespace capcon
