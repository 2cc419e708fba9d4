#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "points/ensemble.h"
#include "points/ranked_order.h"
#include "sampling/bits.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

TEST(RankedSets, AreTheSameSetsInAnotherOrder) {
  Ensemble e = make_ensemble({.points = 64, .sets = 16, .effort = 1e7}), ranked = e;
  rank_cells(ranked, EnsembleDomain::disk);
  EXPECT_NE(ranked.cells, e.cells);
  for (std::size_t s = 0; s < e.sets; ++s) {
    std::sort(&e.cells[s * 64], &e.cells[s * 64] + 64);
    std::vector<std::uint32_t> cells(&ranked.cells[s * 64], &ranked.cells[s * 64] + 64);
    std::sort(cells.begin(), cells.end());
    EXPECT_TRUE(std::equal(cells.begin(), cells.end(), &e.cells[s * 64]));
  }
}

// Every class has a cell in each region, and its regions are nets.
TEST(RankedSets, FirstRegionsAreNets) {
  for (const std::uint32_t k : {2u, 3u, 4u, 5u}) {
    std::set<std::uint32_t> all;
    for (std::uint32_t t = 0; t < (1u << k); ++t) all.insert(ranked_region(t, k));
    EXPECT_EQ(all.size(), 1u << k);
    EXPECT_EQ(*all.rbegin(), (1u << k) - 1);
  }
  // Bits x0 y0 x1 y1: two on both sides of both middles, four in all columns and all rows.
  EXPECT_EQ(ranked_region(0, 4) ^ ranked_region(1, 4), 12u);
  std::set<std::uint32_t> columns, rows;
  for (std::uint32_t t = 0; t < 4; ++t)
    columns.insert(ranked_region(t, 4) & 10), rows.insert(ranked_region(t, 4) & 5);
  EXPECT_EQ(columns.size(), 4u);
  EXPECT_EQ(rows.size(), 4u);
}

/// How many different pairs f and g take over the first n indices.
template <class F, class G>
std::size_t meetings(std::uint32_t n, const F& f, const G& g) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < n; ++i) all.insert({f(i), g(i)});
  return all.size();
}

TEST(RankedSets, RegionsOfTwoPairsMeetInWholeSetsAndInBeginnings) {
  for (const std::uint32_t n : {256u, 1024u}) {
    const std::uint32_t q = matched_regions(n), k = n == 256 ? 4 : 5;
    const auto rank = [&](std::uint32_t pair, std::uint32_t i) {
      return pair == 0 ? i : matched_rank(i, n, pair == 1);
    };
    for (const auto& [a, b] : {std::pair(0u, 1u), {0u, 2u}, {1u, 2u}}) {
      const auto meet = [&, a = a, b = b](std::uint32_t first, std::uint32_t bits) {
        const auto region = [&](std::uint32_t pair, std::uint32_t i) {
          return ranked_region(rank(pair, i) % q, k) >> (k - bits);
        };
        return meetings(
            first, [&](std::uint32_t i) { return region(a, i); },
            [&](std::uint32_t i) { return region(b, i); });
      };
      EXPECT_EQ(meet(n, k), n) << a << b;
      EXPECT_EQ(meet(64, 3), 64u) << n << a << b;
      EXPECT_EQ(meet(16, 2), 16u) << n << a << b;
    }
    for (const std::uint32_t pair : {1u, 2u}) {
      for (const std::uint32_t first : {2u, 4u, 8u, 16u, n}) {
        std::set<std::uint32_t> ranks;
        for (std::uint32_t i = 0; i < first; ++i) ranks.insert(rank(pair, i));
        EXPECT_EQ(ranks.size(), first);
        EXPECT_EQ(*ranks.rbegin(), first - 1) << "another beginning than pair 0's";
      }
    }
    std::set<std::uint32_t> places;
    for (std::uint32_t r = 0; r < n; ++r) places.insert(place_of_rank(r, n));
    EXPECT_EQ(places.size(), n);
    EXPECT_EQ(*places.rbegin(), n - 1);
  }
}

/// Mean squared error at half-planes of the disk.
double half_planes(const char* sampler, std::uint32_t count, std::uint32_t dimension) {
  const auto points = make_sampler(sampler, count, 9);
  double sum = 0;
  constexpr std::uint32_t kPixels = 4000;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    const double a = 2 * std::numbers::pi * uniform64(5, pixel, 0), d = 2 * uniform64(5, pixel, 1) - 1;
    double estimate = -(std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
    for (std::uint32_t i = 0; i < count; ++i) {
      const glm::dvec2 p = into_domain(EnsembleDomain::disk,
                                       to_double(points->sample(pixel, i, dimension, SampleDomain::disk)));
      estimate += p.x * std::cos(a) + p.y * std::sin(a) > d ? 1.0 / count : 0;
    }
    sum += estimate * estimate / kPixels;
  }
  return sum;
}

// Sets of 256, of which the first are taken.
TEST(RankedSets, BeginningsErrLessThanOwens) {
  for (const std::uint32_t count : {8u, 16u, 64u})
    for (const std::uint32_t dimension : {0u, 1u, 3u})
      EXPECT_LT(half_planes("capcon-ranked", count, dimension),
                0.97 * half_planes("sobol-owen", count, dimension))
          << count << " " << dimension;
  EXPECT_LT(half_planes("capcon-ranked", 256, 0), 0.85 * half_planes("sobol-owen", 256, 0));
}

TEST(RankedSets, MorePointsFollowTheFirst) {
  for (const std::uint32_t dimension : {0u, 1u, 3u}) {
    const auto few = make_sampler("capcon-ranked", 10, 3), more = make_sampler("capcon-ranked", 200, 3);
    for (std::uint32_t i = 0; i < 10; ++i)
      EXPECT_EQ(few->sample(7, i, dimension), more->sample(7, i, dimension)) << dimension;
  }
  EXPECT_THROW(make_sampler("capcon-ranked", 1025, 1), InputError);
}

// Each sample alone, so that every beginning is unbiased: chi-square over 8 x 8 cells, 121 is its 0.99999
// quantile for 63 degrees of freedom.
TEST(RankedSets, EverySampleIsUniform) {
  const auto sampler = make_sampler("capcon-ranked", 32, 5);
  for (const SampleDomain domain : {SampleDomain::square, SampleDomain::disk, SampleDomain::cylinder}) {
    for (const std::uint32_t dimension : {0u, 3u}) {
      for (const std::uint32_t index : {0u, 1u, 19u}) {
        std::array<int, 64> cells{};
        constexpr int kPixels = 64000;
        for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
          const FixedPoint p = sampler->sample(pixel, index, dimension, domain);
          ++cells[(p.x >> 29) * 8 + (p.y >> 29)];
        }
        double chi2 = 0;
        for (const int c : cells) chi2 += (c - kPixels / 64.0) * (c - kPixels / 64.0) / (kPixels / 64.0);
        EXPECT_LT(chi2, 121) << static_cast<int>(domain) << " index " << index;
      }
    }
  }
}

}  // namespace
}  // namespace capcon
