#include "points/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/hash.h"

namespace capcon {
namespace {

Points random_points(std::size_t n, std::uint64_t seed) {
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) points[i] = {uniform64(seed, 0, 2 * i), uniform64(seed, 0, 2 * i + 1)};
  return points;
}

double power_by_definition(const Points& points, int kx, int ky) {
  std::complex<double> sum = 0;
  for (const glm::dvec2& p : points) sum += std::polar(1.0, -2 * M_PI * (kx * p.x + ky * p.y));
  return std::norm(sum) / static_cast<double>(points.size());
}

TEST(Spectrum, AgreesWithItsDefinition) {
  const std::vector<Points> sets{random_points(300, 1), random_points(300, 2)};
  const Spectrum spectrum = power_spectrum(sets, 9);
  ASSERT_EQ(spectrum.power.size(), 19u * 19u);
  for (int ky = -9; ky <= 9; ++ky) {
    for (int kx = -9; kx <= 9; ++kx) {
      const double expected =
          (power_by_definition(sets[0], kx, ky) + power_by_definition(sets[1], kx, ky)) / 2;
      EXPECT_NEAR(spectrum.at(kx, ky), expected, 1e-10) << kx << " " << ky;
    }
  }
  EXPECT_NEAR(spectrum.at(0, 0), 300, 1e-9);
}

TEST(Spectrum, HighFrequenciesKeepTheirDigits) {
  const Points points = random_points(40, 3);
  const Spectrum spectrum = power_spectrum({points}, 500);
  for (const int k : {-500, 377, 499})
    EXPECT_NEAR(spectrum.at(k, 500), power_by_definition(points, k, 500), 1e-9);
}

TEST(Spectrum, LatticePeaksAtItsDual) {
  // (i/55, 34 i/55): P(k) = 55 where k_x + 34 k_y is a multiple of 55, else 0; a shift changes nothing.
  Points points;
  for (int i = 0; i < 55; ++i) points.emplace_back(i / 55.0, std::fmod(0.123 + 34.0 * i / 55, 1.0));
  const Spectrum spectrum = power_spectrum({points}, 20);
  int peaks = 0;
  for (int ky = -20; ky <= 20; ++ky) {
    for (int kx = -20; kx <= 20; ++kx) {
      const bool dual = (kx + 34 * ky) % 55 == 0;
      EXPECT_NEAR(spectrum.at(kx, ky), dual ? 55 : 0, 1e-9) << kx << " " << ky;
      peaks += dual;
    }
  }
  EXPECT_GT(peaks, 25);
}

TEST(Spectrum, SameBitsForAnyNumberOfThreads) {
  const std::vector<Points> sets{random_points(2000, 4)};
  ::setenv("CAPCON_THREADS", "1", 1);
  const Spectrum one = power_spectrum(sets, 300);
  ::setenv("CAPCON_THREADS", "3", 1);
  EXPECT_EQ(power_spectrum(sets, 300).power, one.power);
  ::unsetenv("CAPCON_THREADS");
}

TEST(RadialSpectrum, TenWhiteSets) {
  std::vector<Points> sets;
  for (std::uint64_t seed = 0; seed < 10; ++seed) sets.push_back(random_points(256, seed));
  const RadialSpectrum radial = radial_spectrum(power_spectrum(sets, default_reach(256)));
  ASSERT_EQ(radial.mean.size(), 40u);
  EXPECT_DOUBLE_EQ(radial.frequency.back(), 40 / 16.0);
  double mean = 0;
  for (const double p : radial.mean) mean += p / 40;
  EXPECT_NEAR(mean, 1, 0.03);  // 2500 independent frequencies of 10 exponential variables each
  EXPECT_NEAR(radial.low, 1, 0.12);
  EXPECT_NEAR(radial.mean_anisotropy, -10, 0.4);
  for (std::size_t r = 20; r < 40; ++r) EXPECT_NEAR(radial.mean[r], 1, 0.2);
}

TEST(RadialSpectrum, OneWhiteSet) {
  const RadialSpectrum radial = radial_spectrum(power_spectrum({random_points(1024, 5)}, 80));
  EXPECT_NEAR(radial.mean_anisotropy, 0, 0.5);
}

TEST(RadialSpectrum, RingsOfAKnownSquare) {
  // P = |k|^2 on a square of reach 2. Ring 1: 1, 1, 2, 2 (one of each pair); ring 2: 4, 4, 5, 5, 5, 5.
  Spectrum spectrum{4, 1, 2, std::vector<double>(25)};
  for (int ky = -2; ky <= 2; ++ky) {
    for (int kx = -2; kx <= 2; ++kx) spectrum.power[std::size_t(ky + 2) * 5 + kx + 2] = kx * kx + ky * ky;
  }
  const RadialSpectrum radial = radial_spectrum(spectrum);
  ASSERT_EQ(radial.mean.size(), 2u);
  EXPECT_DOUBLE_EQ(radial.mean[0], 1.5);
  EXPECT_DOUBLE_EQ(radial.mean[1], 28.0 / 6);
  EXPECT_NEAR(radial.anisotropy[0], 10 * std::log10((1.0 / 3) / 2.25), 1e-12);
  EXPECT_NEAR(radial.anisotropy[1], 10 * std::log10((4.0 / 3 / 5) / std::pow(28.0 / 6, 2)), 1e-12);
  EXPECT_DOUBLE_EQ(radial.low, 1);  // |k| <= 1
  EXPECT_DOUBLE_EQ(radial.peak_frequency, 1);
}

TEST(RadialSpectrum, WhatIsNotThereIsNotANumber) {
  // A lattice: no power between the dual's points, so no anisotropy there but rounding's.
  Points points;
  for (int i = 0; i < 64; ++i) points.emplace_back((i % 8 + 0.3) / 8, (i / 8 + 0.6) / 8);
  const RadialSpectrum lattice = radial_spectrum(power_spectrum({points}, 20));
  EXPECT_TRUE(std::isnan(lattice.anisotropy[3]));  // ring 4
  EXPECT_GT(lattice.anisotropy[7], 0);             // ring 8 holds (8, 0)
  EXPECT_GT(lattice.mean_anisotropy, 0);
  EXPECT_EQ(lattice.peak_frequency, 1);
  EXPECT_TRUE(std::isnan(radial_spectrum(power_spectrum({{{0.5, 0.5}}}, 4)).low));
}

TEST(RadialSpectrum, IsotropicPowerHasNoAnisotropy) {
  const Spectrum flat{100, 1, 10, std::vector<double>(21 * 21, 3.0)};
  const RadialSpectrum radial = radial_spectrum(flat);
  EXPECT_EQ(radial.anisotropy[5], -100);
  EXPECT_EQ(radial.mean_anisotropy, -100);
  const auto json = to_json(flat, radial, false);
  EXPECT_EQ(json.at("radial_mean").size(), 10u);
  EXPECT_FALSE(json.contains("power"));
}

}  // namespace
}  // namespace capcon
