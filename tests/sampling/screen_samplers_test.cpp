#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "points/ensemble.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

// Over seeds: within an image pixels are not independent. The bound is 4.5 standard errors.
TEST(ScreenSamplers, EveryPixelIsUnbiased) {
  for (const char* name : {"capcon-screen", "sobol-z"}) {
    for (const std::uint32_t pixel : {0u, 777u}) {
      double sums[2] = {}, squares[2] = {};
      constexpr int kSeeds = 20000;
      for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const auto sampler = make_sampler(name, 4, seed, 1, 100);
        double estimates[2] = {};
        for (std::uint32_t i = 0; i < 4; ++i) {
          const glm::dvec2 p =
              into_domain(EnsembleDomain::disk, to_double(sampler->sample(pixel, i, 0, SampleDomain::disk)));
          estimates[0] += p.x + 0.5 * p.y > 0.4 ? 0.25 : 0;
          estimates[1] += 0.25 * std::exp(p.x) * p.y * p.y;
        }
        for (int k = 0; k < 2; ++k) sums[k] += estimates[k], squares[k] += estimates[k] * estimates[k];
      }
      // A segment at distance 0.4 / |(1, 0.5)|; the other by its series: the mean of x^2k y^2 over the disk.
      const double d = 0.4 / std::sqrt(1.25);
      double series = 0, factorial = 1;
      for (int k = 0; k < 10; ++k) {
        if (k > 0) factorial *= (2.0 * k) * (2.0 * k - 1);
        series +=
            std::tgamma(k + 0.5) * std::tgamma(1.5) / (std::numbers::pi * std::tgamma(k + 3.0)) / factorial;
      }
      const double integrals[2] = {(std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi, series};
      for (int k = 0; k < 2; ++k) {
        const double mean = sums[k] / kSeeds, error = std::sqrt((squares[k] / kSeeds - mean * mean) / kSeeds);
        EXPECT_LT(std::abs(mean - integrals[k]), 4.5 * error)
            << name << " pixel " << pixel << " integrand " << k;
      }
    }
  }
}

// What makes its error blue: every aligned block of 2 x 2 pixels with 4 points each has a net of 16.
TEST(ScreenSamplers, BlocksOfPixelsOfSobolZAreNets) {
  constexpr int kWidth = 10;
  const auto sampler = make_sampler("sobol-z", 4, 3, 1, kWidth);
  for (const std::uint32_t corner : {0u, 2u, 4u * kWidth + 6u}) {
    for (const std::uint32_t dimension : {0u, 5u}) {
      for (int across = 1; across <= 16; across *= 2) {
        std::set<int> boxes;
        for (const std::uint32_t pixel : {corner, corner + 1, corner + kWidth, corner + kWidth + 1}) {
          for (std::uint32_t i = 0; i < 4; ++i) {
            const glm::dvec2 p = to_double(sampler->sample(pixel, i, dimension));
            boxes.insert(int(p.x * across) + across * int(p.y * (16 / across)));
          }
        }
        EXPECT_EQ(boxes.size(), 16u) << corner << " " << across;
      }
    }
  }
}

TEST(ScreenSamplers, WidthDecidesWhoIsBelow) {
  for (const char* name : {"capcon-screen", "sobol-z"}) {
    const auto narrow = make_sampler(name, 4, 3, 1, 16), wide = make_sampler(name, 4, 3, 1, 32);
    EXPECT_EQ(narrow->sample(5, 2, 0), wide->sample(5, 2, 0)) << name;
    EXPECT_NE(narrow->sample(40, 2, 0), wide->sample(40, 2, 0)) << name;
  }
  EXPECT_THROW(make_sampler("capcon-screen", 257, 1), InputError);
}

}  // namespace
}  // namespace capcon
