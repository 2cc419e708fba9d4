#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/hash.h"
#include "points/ensemble.h"
#include "sampling/bits.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

TEST(MatchedPlace, RegionsArePowersOfTwoWhoseSquareFits) {
  for (std::uint32_t n = 1; n <= 4096; ++n) {
    const std::uint32_t q = matched_regions(n);
    EXPECT_EQ(n % q, 0u) << n;
    EXPECT_LE(q * q, n);
    EXPECT_TRUE(n % (2 * q) != 0 || 4 * q * q > n) << n;
  }
}

TEST(MatchedPlace, IsAPermutation) {
  for (const std::uint32_t n : {4u, 6u, 8u, 12u, 16u, 20u, 32u, 36u, 64u, 96u, 256u, 1000u, 1024u, 4096u}) {
    for (std::uint32_t key = 5; key < 0xf0000000u; key += 0x13579bdfu) {
      for (const bool one : {false, true}) {
        std::set<std::uint32_t> places;
        for (std::uint32_t i = 0; i < n; ++i) places.insert(matched_place(i, n, one, key));
        EXPECT_EQ(places.size(), n);
        EXPECT_EQ(*places.rbegin(), n - 1) << n;
      }
    }
  }
}

// What makes integrands of two pairs smooth to them: every region of one meets each of the other's.
TEST(MatchedPlace, EveryRegionMeetsEveryOther) {
  for (const std::uint32_t n : {16u, 32u, 64u, 128u, 256u, 512u, 1024u, 4096u}) {
    const std::uint32_t q = matched_regions(n), m = n / q;
    std::vector<std::uint32_t> together[3];
    for (auto& t : together) t.resize(std::size_t(q) * q);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = i / m, b = matched_place(i, n, true, 0xdeadbeef) / m,
                          c = matched_place(i, n, false, 0x87654321) / m;
      ++together[0][a * q + b], ++together[1][a * q + c], ++together[2][b * q + c];
    }
    for (const auto& t : together)
      for (const std::uint32_t times : t) EXPECT_EQ(times, n / (q * q)) << n;
  }
}

// Whatever sample it is: over keys every place is as likely.
TEST(MatchedPlace, IsUniformOverKeys) {
  for (const std::uint32_t n : {12u, 16u, 20u, 64u}) {
    for (const std::uint32_t index : {0u, n / 2 + 1}) {
      std::vector<double> times(n);
      const int keys = 20000 * int(n);
      for (int k = 0; k < keys; ++k)
        ++times[matched_place(index, n, k % 2 == 0, static_cast<std::uint32_t>(mix64(1, 2, k)))];
      for (const double t : times) EXPECT_NEAR(t, 20000, 5 * std::sqrt(20000.0)) << n;
    }
  }
}

/// Mean squared error of a shadow that moves with the place in the pixel, an edge of the light's disk.
double moving_shadow(const char* sampler, std::uint32_t n) {
  const auto image = make_sampler(sampler, n, 1), light = make_sampler(sampler, n, 2);
  double sum = 0;
  constexpr std::uint32_t kTrials = 1500;
  for (std::uint32_t t = 0; t < kTrials; ++t) {
    const double turn = 2 * std::numbers::pi * uniform64(3, t, 0), across = uniform64(3, t, 1) - 0.5;
    const auto lit = [&](glm::dvec2 p, glm::dvec2 x) {
      return x.x * std::cos(turn) + x.y * std::sin(turn) + (p.x - 0.5) > across ? 1.0 : 0.0;
    };
    double estimate = 0, truth = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::dvec2 x =
          into_domain(EnsembleDomain::disk, to_double(light->sample(t, i, 3, SampleDomain::disk)));
      estimate += lit(to_double(image->sample(t, i, 1)), x) / n;
    }
    // Chords of the disk, over the pixel.
    for (int k = 0; k < 64; ++k) {
      const double d = std::clamp(across - ((k + 0.5) / 64 - 0.5), -1.0, 1.0);
      truth += (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi / 64;
    }
    sum += (estimate - truth) * (estimate - truth) / kTrials;
  }
  return sum;
}

TEST(MatchedPlace, PixelsAndLightsErrLessTogetherThanPaddedNets) {
  EXPECT_LT(moving_shadow("capcon-domain", 16), 0.9 * moving_shadow("sobol-owen", 16));
  EXPECT_LT(moving_shadow("capcon-domain", 64), 0.8 * moving_shadow("sobol-owen", 64));
  // A number that regions do not divide.
  EXPECT_LT(moving_shadow("capcon-domain", 15), moving_shadow("random", 15));
}

}  // namespace
}  // namespace capcon
