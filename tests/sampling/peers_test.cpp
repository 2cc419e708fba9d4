#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "points/spread_partition.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

/// One of points first ... first + 2^m - 1 in each elementary interval of area 2^-m.
bool is_net(const Sampler& sampler, std::uint32_t pixel, std::uint32_t dimension, std::uint32_t first,
            std::uint32_t m) {
  for (std::uint32_t j = 0; j <= m; ++j) {
    std::set<std::uint64_t> cells;
    for (std::uint32_t i = first; i < first + (1u << m); ++i) {
      const FixedPoint p = sampler.sample(pixel, i, dimension);
      cells.insert((static_cast<std::uint64_t>(p.x) << j >> 32) << (m - j) |
                   static_cast<std::uint64_t>(p.y) << (m - j) >> 32);
    }
    if (cells.size() != 1u << m) return false;
  }
  return true;
}

// Sets and parts of a power of two are nets, whichever sequence, scrambling and order a pixel has.
TEST(Peers, Pmj02SetsAndPartsAreNets) {
  struct Case {
    std::uint32_t count, parts, m;
  };
  for (const Case c : {Case{16, 1, 4}, Case{256, 1, 8}, Case{64, 8, 3}, Case{48, 3, 4}, Case{1024, 8, 7}}) {
    const auto sampler = make_sampler("pmj02", c.count, 7, c.parts);
    for (const std::uint32_t pixel : {0u, 5u, 1234u}) {
      for (const std::uint32_t dimension : {0u, 1u, 5u}) {
        for (std::uint32_t part = 0; part < c.parts; ++part)
          EXPECT_TRUE(is_net(*sampler, pixel, dimension, part << c.m, c.m)) << c.count << " part " << part;
        if (std::has_single_bit(c.count)) {
          EXPECT_TRUE(
              is_net(*sampler, pixel, dimension, 0, static_cast<std::uint32_t>(std::countr_zero(c.count))));
        }
      }
    }
  }
}

// Pixels take their sets from 64 sequences: up to the XOR, which differences of points cancel, there are 64
// of them.
TEST(Peers, Pmj02PixelsChooseAmongSequences) {
  const auto sampler = make_sampler("pmj02", 16, 7);
  std::set<std::uint64_t> sequences;
  for (std::uint32_t pixel = 0; pixel < 2000; ++pixel) {
    const FixedPoint a = sampler->sample(pixel, 0, 0), b = sampler->sample(pixel, 1, 0);
    sequences.insert(static_cast<std::uint64_t>(a.x ^ b.x) << 32 | (a.y ^ b.y));
  }
  EXPECT_EQ(sequences.size(), 64u);
}

Points set_of(const Sampler& sampler, std::uint32_t pixel) {
  Points points;
  for (std::uint32_t i = 0; i < sampler.count(); ++i)
    points.push_back(to_double(sampler.sample(pixel, i, 0)));
  return points;
}

/// Squared distance on the torus.
double distance2(glm::dvec2 a, glm::dvec2 b) {
  const double x = std::remainder(a.x - b.x, 1.0), y = std::remainder(a.y - b.y, 1.0);
  return x * x + y * y;
}

// A lattice of n points: every point has the same nearest distance, the largest that any generator gives (all
// are tried here), and it is turned as it is, never sheared.
TEST(Peers, LatticeIsTheMostSpreadOne) {
  for (const std::uint32_t n : {5u, 16u, 17u, 64u, 100u}) {
    double best = 0;
    for (std::uint32_t g = 1; g < n; ++g) {
      double least = 1;
      for (std::uint32_t k = 1; k < n; ++k)
        least = std::min(least, distance2({0, 0}, {double(k) / n, double(k * g % n) / n}));
      best = std::max(best, least);
    }
    const Points points = set_of(*make_sampler("lattice", n, 3), 8);
    for (std::size_t i = 0; i < n; ++i) {
      double nearest = 1;
      for (std::size_t j = 0; j < n; ++j)
        nearest = i == j ? nearest : std::min(nearest, distance2(points[i], points[j]));
      EXPECT_NEAR(std::sqrt(nearest), std::sqrt(best), 1e-8) << n;
    }
  }
}

// Cutting only orders the points; parts are the lattice's cosets or the partition of ccvt and fpo, whichever
// are more spread, in units of the hexagonal lattice's distance: 0.931 is the best lattice of 16 points.
TEST(Peers, LatticePartsAreSpreadAndTheirUnionIsTheLattice) {
  struct Case {
    std::uint32_t count, parts;
    double mean;
  };
  for (const Case c : {Case{16, 4, 0.93}, Case{36, 6, 0.80}, Case{50, 5, 0.83}, Case{64, 4, 0.93},
                       Case{128, 8, 0.93}, Case{256, 16, 0.84}, Case{512, 4, 0.87}}) {
    const auto key = [](glm::dvec2 p) { return std::pair(p.x, p.y); };
    Points cut = set_of(*make_sampler("lattice", c.count, 5, c.parts), 3),
           whole = set_of(*make_sampler("lattice", c.count, 5), 3);
    std::vector<std::uint32_t> labels(c.count);
    for (std::uint32_t i = 0; i < c.count; ++i) labels[i] = i / (c.count / c.parts);
    EXPECT_GT(subset_spacing(cut, labels, c.parts).mean, c.mean) << c.count << " in " << c.parts;
    std::ranges::sort(cut, {}, key);
    std::ranges::sort(whole, {}, key);
    EXPECT_EQ(cut, whole) << c.count << " in " << c.parts;
  }
}

}  // namespace
}  // namespace capcon
