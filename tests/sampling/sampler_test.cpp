#include "sampling/sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "sampling/bits.h"

namespace capcon {
namespace {

std::vector<glm::dvec2> set_of(const Sampler& sampler, std::uint32_t pixel, std::uint32_t dimension) {
  std::vector<glm::dvec2> points;
  for (std::uint32_t i = 0; i < sampler.count(); ++i) {
    const FixedPoint p = sampler.sample(pixel, i, dimension);
    points.emplace_back(to_unit_float(p.x), to_unit_float(p.y));
  }
  return points;
}

TEST(Sampler, UnknownNameListsTheKnownOnes) {
  try {
    make_sampler("halotn", 16, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("sobol-owen"), std::string::npos);
  }
  EXPECT_THROW(make_sampler("random", 0, 1), InputError);
  EXPECT_THROW(make_sampler("capcon", (1u << 20) + 1, 1), InputError) << "more vertices than 16 bits number";
  EXPECT_EQ(make_sampler("capcon", 1u << 20, 1)->tables().constants[0], 65536u);
}

// Every elementary interval of area 1/n holds one point: the (0, m, 2)-net property, for both scramblings.
TEST(Sampler, SobolSetsAreNets) {
  for (const char* name : {"sobol-xor", "sobol-owen"}) {
    const auto sampler = make_sampler(name, 64, 7);
    for (std::uint32_t dimension : {0u, 1u, 5u}) {
      const auto points = set_of(*sampler, 1234, dimension);
      for (int split = 0; split <= 6; ++split) {
        std::set<std::pair<int, int>> cells;
        for (const auto p : points) cells.insert({int(p.x * (1 << split)), int(p.y * (64 >> split))});
        EXPECT_EQ(cells.size(), 64u) << name << " dimension " << dimension << " split " << split;
      }
    }
  }
}

// Published values of the second Sobol' dimension (Joe and Kuo's direction numbers): 0, 1/2, 3/4, 1/4, 5/8, 1/8, 3/8, 7/8.
TEST(Sampler, SecondSobolDimensionHasPublishedValues) {
  const double expected[] = {0, .5, .75, .25, .625, .125, .375, .875};
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(reverse_bits(sobol_second_reversed(i)) * 0x1p-32, expected[i]);
  // And far out in the sequence against the recurrence of its direction numbers v' = v ^ (v >> 1).
  for (std::uint32_t i : {123456789u, 0xffffffffu, 0x80000001u}) {
    std::uint32_t value = 0, v = 0x80000000u;
    for (std::uint32_t bits = i; bits != 0; bits >>= 1, v ^= v >> 1) value ^= (bits & 1) ? v : 0;
    EXPECT_EQ(reverse_bits(sobol_second_reversed(i)), value);
  }
}

TEST(Sampler, OwenScramblingNeverMovesABitByAHigherOne) {
  for (std::uint32_t i = 0; i < 32; ++i) {
    const std::uint32_t flip = owen_scramble_reversed(0x12345678u, 99) ^ owen_scramble_reversed(0x12345678u ^ (1u << i), 99);
    EXPECT_EQ(flip & ((1u << i) - 1), 0u);  // lower bits (more significant digits) stay
    EXPECT_EQ(flip >> i & 1u, 1u);
  }
}

TEST(Sampler, ShuffleIsAPermutation) {
  for (std::uint32_t count : {1u, 2u, 3u, 12u, 16u, 37u, 64u, 100u}) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < count; ++i) seen.insert(shuffle_index(i, count, coprime_stride(count), 0xdeadbeef));
    EXPECT_EQ(seen.size(), count);
    EXPECT_LT(*seen.rbegin(), count);
  }
}

TEST(Sampler, JitteredHasOnePointAStratum) {
  for (std::uint32_t count : {16u, 32u, 12u, 7u}) {
    const auto sampler = make_sampler("jittered", count, 3);
    const auto columns = sampler->tables().constants[0], rows = sampler->tables().constants[1];
    ASSERT_EQ(columns * rows, count);
    for (std::uint32_t dimension : {0u, 1u}) {
      std::set<std::pair<int, int>> cells;
      for (const auto p : set_of(*sampler, 5, dimension)) cells.insert({int(p.x * columns), int(p.y * rows)});
      EXPECT_EQ(cells.size(), count);
    }
  }
}

// Sets of different pixels, dimensions and seeds differ; the same address gives the same bits.
TEST(Sampler, AddressesDecideThePoints) {
  for (const std::string& name : sampler_names()) {
    const auto a = make_sampler(name, 32, 1), again = make_sampler(name, 32, 1), other = make_sampler(name, 32, 2);
    EXPECT_EQ(a->sample(10, 3, 0), again->sample(10, 3, 0)) << name;
    EXPECT_NE(a->sample(10, 3, 0), a->sample(11, 3, 0)) << name;
    EXPECT_NE(a->sample(10, 3, 0), a->sample(10, 3, 1)) << name;
    EXPECT_NE(a->sample(10, 3, 0), other->sample(10, 3, 0)) << name;
    EXPECT_NE(a->sample(10, 3, 0), a->sample(10, 4, 0)) << name;
  }
}

// Unbiased: the mean of the estimate over many pixels is the integral, for a smooth and a discontinuous integrand, at every
// kind of count. The bound is 4.5 standard errors: a false alarm once in 10^5 comparisons.
TEST(Sampler, EstimatesAreUnbiased) {
  const auto smooth = [](glm::dvec2 p) { return std::exp(p.x) * p.y * p.y; };
  const double smooth_integral = (std::exp(1.0) - 1) / 3;
  const auto disk = [](glm::dvec2 p) { return std::hypot(p.x - 0.4, p.y - 0.5) < 0.35 ? 1.0 : 0.0; };
  const double disk_integral = M_PI * 0.35 * 0.35;
  for (const std::string& name : sampler_names()) {
    for (std::uint32_t count : {1u, 3u, 8u, 16u, 17u, 32u, 50u}) {
      const auto sampler = make_sampler(name, count, 11);
      for (const auto& [f, integral] : {std::pair<std::function<double(glm::dvec2)>, double>{smooth, smooth_integral},
                                        {disk, disk_integral}}) {
        constexpr int kPixels = 4000;
        double sum = 0, squares = 0;
        for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
          double estimate = 0;
          for (const auto p : set_of(*sampler, pixel, 0)) estimate += f(p) / count;
          sum += estimate;
          squares += estimate * estimate;
        }
        const double mean = sum / kPixels;
        const double error = std::sqrt(std::max(1e-12, squares / kPixels - mean * mean) / kPixels);
        EXPECT_LT(std::abs(mean - integral), 4.5 * error) << name << " " << count;
      }
    }
  }
}

// A point of every sampler is uniform by itself: 8 x 8 cells over pixels, chi-square with 63 degrees of freedom; 121 is its
// 0.99999 quantile.
TEST(Sampler, EveryPointIsUniform) {
  for (const std::string& name : sampler_names()) {
    const auto sampler = make_sampler(name, 16, 5);
    for (std::uint32_t index : {0u, 7u, 15u}) {
      std::array<int, 64> cells{};
      constexpr int kPixels = 64000;
      for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        const FixedPoint p = sampler->sample(pixel, index, 2);
        ++cells[(p.x >> 29) * 8 + (p.y >> 29)];
      }
      double chi2 = 0;
      for (const int c : cells) chi2 += (c - kPixels / 64.0) * (c - kPixels / 64.0) / (kPixels / 64.0);
      EXPECT_LT(chi2, 121) << name << " index " << index;
    }
  }
}

double mean_spacing(const std::vector<glm::dvec2>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = 1;  // its own image
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const double x = std::remainder(points[i].x - points[j].x, 1.0), y = std::remainder(points[i].y - points[j].y, 1.0);
      nearest = std::min(nearest, std::hypot(x, y));
    }
    sum += nearest;
  }
  const auto n = static_cast<double>(points.size());
  return sum / n / std::sqrt(2 / (std::sqrt(3.0) * n));
}

// What tiles and their ranks are for: sets of any size are far more even than random ones. Mean nearest distance in units
// of the hexagonal lattice's: about 0.47 for random points, 0.61 for Owen-scrambled Sobol' points.
TEST(Sampler, TiledSetsOfAnySizeAreEven) {
  double least = 1;
  std::uint32_t worst = 0;
  for (std::uint32_t n = 1; n <= 160; ++n) {
    const auto sampler = make_sampler("capcon", n, 9);
    double mean = 0;
    for (std::uint32_t pixel = 0; pixel < 8; ++pixel) mean += mean_spacing(set_of(*sampler, pixel, 0)) / 8;
    if (mean < least) least = mean, worst = n;
  }
  EXPECT_GT(least, 0.67) << "n = " << worst;
  const auto sampler = make_sampler("capcon", 64, 9);
  double full = 0;
  for (std::uint32_t pixel = 0; pixel < 50; ++pixel) full += mean_spacing(set_of(*sampler, pixel, 0)) / 50;
  EXPECT_GT(full, 0.83);  // whole tiles
}

// A block of 2^a 3^b successive points has one in each of its 2^a x 3^b boxes, wherever in the sequence it begins.
TEST(Sampler, HaltonPartsHaveOnePointABox) {
  const auto sampler = make_sampler("halton", 6 * 144, 3, 6);  // 144 = 2^4 3^2
  const auto origin = sampler->sample(8, 0, 0);                // the sequence begins at 0: this is the shift
  for (std::uint32_t part = 0; part < 6; ++part) {
    std::set<std::pair<int, int>> boxes;
    for (std::uint32_t i = 0; i < 144; ++i) {
      const FixedPoint p = sampler->sample(8, 144 * part + i, 0);
      // Radical inverses in base 3 are rounded down to 2^-32: a unit keeps them in their box.
      boxes.insert({int((p.x - origin.x) * 0x1p-32 * 16), int((p.y - origin.y + 1.0) * 0x1p-32 * 9)});
    }
    EXPECT_EQ(boxes.size(), 144u) << part;
  }
}

// Schloemer, Heck and Deussen give 0.93 for the mean distance of whole sets.
TEST(Sampler, FarthestPointSetsAreSpread) {
  EXPECT_GT(mean_spacing(set_of(*make_sampler("fpo", 128, 3), 2, 0)), 0.92);
}

TEST(Sampler, StudiesCompareKnownSamplers) {
  for (const std::string& name : default_study_samplers())
    EXPECT_TRUE(std::ranges::count(sampler_names(), name) == 1) << name;
  EXPECT_EQ(default_study_samplers().size(), 7u);
}

}  // namespace
}  // namespace capcon
