#include "points/ccvt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/hash.h"
#include "points/ccvt_cells.h"
#include "points/ccvt_exchange.h"
#include "points/ccvt_optimise.h"
#include "points/ccvt_start.h"
#include "points/generators.h"
#include "points/lattice.h"
#include "points/measure.h"

namespace capcon {
namespace {

double wrapped(double d) {
  return d - std::round(d);
}

glm::dvec2 position(const CcvtSite& site) {
  return {(site.centre.x + site.x) * 0x1p-32, (site.centre.y + site.y) * 0x1p-32};
}

double squared(glm::dvec2 a, glm::dvec2 b) {
  const double x = wrapped(a.x - b.x), y = wrapped(a.y - b.y);
  return x * x + y * y;
}

glm::dvec2 space_point(const CcvtCells& cells, std::size_t i, std::uint32_t k) {
  return {cells.x(i)[k] * 0x1p-32, cells.y(i)[k] * 0x1p-32};
}

double energy_of(const CcvtCells& cells) {
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
      sum += squared(space_point(cells, i, k), position(cells.sites[i]));
    }
  }
  return sum / cells.capacity();
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> all_space_points(const CcvtCells& cells) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::size_t k = 0; k < cells.size() * cells.capacity(); ++k)
    all.emplace_back(cells.x(0)[k], cells.y(0)[k]);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Lattice, ShortestVectorAgreesWithSearch) {
  for (std::uint64_t m = 1; m < 60; ++m) {
    for (std::uint64_t g = 0; g < m; ++g) {
      std::uint64_t best = m * m;
      for (std::int64_t a = -60; a <= 60; ++a) {
        for (std::int64_t b = -60; b <= 60; ++b) {
          const std::int64_t y = a * static_cast<std::int64_t>(g) + b * static_cast<std::int64_t>(m);
          if (a != 0 || y != 0) best = std::min(best, static_cast<std::uint64_t>(a * a + y * y));
        }
      }
      const auto basis = reduced_basis(m, g);
      const auto length2 = [](glm::i64vec2 v) { return static_cast<std::uint64_t>(v.x * v.x + v.y * v.y); };
      EXPECT_EQ(length2(basis[0]), best) << m << " " << g;
      EXPECT_LE(length2(basis[0]), length2(basis[1]));
      EXPECT_EQ(std::abs(basis[0].x * basis[1].y - basis[0].y * basis[1].x), static_cast<std::int64_t>(m));
    }
  }
}

TEST(Lattice, IsNearlyHexagonalForAnyCount) {
  for (const std::uint64_t m : {257ull, 1000ull, 1024ull, 2310ull, 6007ull, 65536ull}) {
    Points points;
    for (const TorusPoint p : points_of(even_lattice(m))) points.emplace_back(p.x * 0x1p-32, p.y * 0x1p-32);
    ASSERT_EQ(points.size(), m);
    EXPECT_GT(measure(points).delta_min, 0.9) << m;
    EXPECT_NEAR(measure(points).area_sd, 0, 1e-4) << m;
  }
}

TEST(Lattice, HilbertOrderIsAPathThroughNeighbours) {
  std::vector<TorusPoint> points;
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) points.push_back({x << 26, y << 26});
  }
  const auto order = hilbert_order(points);
  EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), points.size());
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const TorusPoint a = points[order[k]], b = points[order[k + 1]];
    const std::uint32_t step = (a.x > b.x ? a.x - b.x : b.x - a.x) + (a.y > b.y ? a.y - b.y : b.y - a.y);
    ASSERT_EQ(step, 1u << 26);
  }
}

/// The best that one pair can do at fixed sites: sort all 2K points by their difference of squared distances.
double best_pair_energy(const CcvtCells& cells, std::size_t i, std::size_t j) {
  const glm::dvec2 si = position(cells.sites[i]), sj = position(cells.sites[j]);
  std::vector<double> difference;
  double sum = 0;
  for (const std::size_t s : {i, j}) {
    for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
      const glm::dvec2 p = space_point(cells, s, k);
      sum += squared(p, sj);
      difference.push_back(squared(p, si) - squared(p, sj));
    }
  }
  std::sort(difference.begin(), difference.end());
  return std::accumulate(difference.begin(), difference.begin() + cells.capacity(), sum);
}

TEST(CcvtExchange, IsTheBestForThePairAndMovesToTheCentroids) {
  for (const std::uint32_t sites : {2u, 3u, 5u, 40u, 300u}) {
    CcvtCells cells = random_cells(sites, 37, 5).cells;
    const auto before = all_space_points(cells);
    CcvtScratch scratch;
    int exchanged = 0;
    for (std::size_t trial = 0; trial < 400; ++trial) {
      const std::size_t i = mix64(1, 2, 2 * trial) % sites, j = mix64(1, 2, 2 * trial + 1) % sites;
      if (i == j) continue;
      const double best = best_pair_energy(cells, i, j);
      const glm::dvec2 old_i = position(cells.sites[i]), old_j = position(cells.sites[j]);
      const double energy = energy_of(cells);
      const std::uint32_t count = exchange(cells, i, j, scratch);
      if (count == 0) continue;
      ++exchanged;
      EXPECT_LT(energy_of(cells), energy);
      double sum = 0;  // of the new cells about the old sites: what the exchange alone has reached
      for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
        sum += squared(space_point(cells, i, k), old_i) + squared(space_point(cells, j, k), old_j);
      }
      EXPECT_NEAR(sum, best, 1e-5 * best);
      for (const std::size_t s : {i, j}) {
        glm::dvec2 mean(0);
        bool tie = false;  // a point half the torus away has two nearest images
        for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
          const glm::dvec2 p = space_point(cells, s, k);
          const glm::dvec2 d(wrapped(p.x - position(cells.sites[s]).x),
                             wrapped(p.y - position(cells.sites[s]).y));
          tie |= std::max(std::abs(d.x), std::abs(d.y)) > 0.5 - 0x1p-31;
          mean += d / static_cast<double>(cells.capacity());
        }
        if (!tie) {
          EXPECT_NEAR(std::hypot(mean.x, mean.y), 0, 1e-9);
        }
      }
    }
    EXPECT_GT(exchanged, 0) << sites;
    EXPECT_EQ(all_space_points(cells), before) << "a space point was lost or doubled";
  }
}

TEST(CcvtExchange, BoundsHoldAfterAnyExchange) {
  CcvtCells cells = random_cells(60, 50, 9).cells;
  CcvtScratch scratch;
  for (std::size_t trial = 0; trial < 3000; ++trial) {
    const std::size_t i = mix64(3, 2, 2 * trial) % 60, j = mix64(3, 2, 2 * trial + 1) % 60;
    if (i != j) exchange(cells, i, j, scratch);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CcvtSite& site = cells.sites[i];
    for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
      const double distance =
          std::hypot(difference(cells.x(i)[k], site.centre.x), difference(cells.y(i)[k], site.centre.y));
      EXPECT_LE(distance, site.reach);
      if (k >= site.outer) {
        EXPECT_LE(distance, site.inner);
      }
    }
  }
}

TEST(CcvtStart, RefiningKeepsTheCells) {
  CcvtState coarse = random_cells(500, 16, 2);
  optimise(coarse.cells);
  for (const std::uint32_t capacity : {64u, 16u, 37u, 100u}) {
    const CcvtState fine = refined_cells(coarse, capacity, 2);
    ASSERT_EQ(fine.cells.size(), 500u);
    EXPECT_EQ(fine.cells.capacity(), capacity);
    EXPECT_EQ(fine.lattice.m, 500u * capacity);
    const auto all = all_space_points(fine.cells);
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), 500u * capacity);
    Points points;  // even again
    for (const auto& [x, y] : all) points.emplace_back(x * 0x1p-32, y * 0x1p-32);
    EXPECT_GT(measure(points).delta_min, 0.9);
    EXPECT_LT(measure(points).area_sd, 1e-3);
    EXPECT_LT(energy_of(fine.cells), (capacity == 64 ? 1.1 : 10) * energy_of(coarse.cells)) << capacity;
  }
}

/// No pair of sites can gain: brute force over all pairs, in double, with nearest images.
TEST(Ccvt, EndsWhereNoPairCanGain) {
  for (const auto& [n, k] : {std::pair(2u, 50u), std::pair(7u, 33u), std::pair(60u, 16u)}) {
    CcvtCells cells = random_cells(n, k, 4).cells;
    optimise(cells);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        double now = 0;
        for (std::uint32_t q = 0; q < k; ++q) {
          now += squared(space_point(cells, i, q), position(cells.sites[i]));
          now += squared(space_point(cells, j, q), position(cells.sites[j]));
        }
        EXPECT_GE(best_pair_energy(cells, i, j), now * (1 - 1e-5)) << n << ": " << i << ", " << j;
      }
    }
  }
}

TEST(Ccvt, AnyCountAnyCapacity) {
  for (const std::uint32_t n : {1u, 2u, 3u, 4u, 5u, 16u, 31u}) {
    for (const std::uint32_t k : {1u, 2u, 3u, 17u, 64u, 100u}) {
      const CcvtResult result = ccvt({n, k, 7, {}, {}});
      ASSERT_EQ(result.points.size(), n);
      EXPECT_TRUE(std::isfinite(result.energy));
      for (const glm::dvec2& p : result.points) {
        EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << n << " " << k;
      }
      if (k >= 64) {
        EXPECT_LT(measure(result.points).energy, 1.3) << n << " " << k;
      }
    }
  }
  EXPECT_THROW(ccvt({0, 8, 1, {}, {}}), InputError);
  EXPECT_THROW(ccvt({8, 0, 1, {}, {}}), InputError);
  EXPECT_THROW(ccvt({1u << 20, 1u << 20, 1, {}, {}}), InputError);
}

TEST(Ccvt, EnergyFallsToTheKnownValues) {
  // Energy of the discrete cells above that of the ordinary ones: about 1/K of it, the spread of a space
  // point's own cell. Means of three seeds with the 2009 program: 1.0731 at K = 64, 1.0582 at K = 256 (n =
  // 1024).
  for (const auto& [k, known] : {std::pair(64u, 1.0731), std::pair(256u, 1.0582)}) {
    double energy = 0, delta = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      double last = 1e9, discrete = 0, progress = 0;
      std::uint64_t last_swaps = 1;
      const CcvtResult result = ccvt({1024, k, seed,
                                      [&](double e, std::uint64_t swaps) {
                                        EXPECT_LE(e, last);
                                        if (swaps > 0) {
                                          EXPECT_LT(e, last);
                                        }
                                        last = discrete = e;
                                        last_swaps = swaps;
                                      },
                                      [&](double fraction) {
                                        EXPECT_TRUE(fraction >= progress && fraction <= 1);
                                        progress = fraction;
                                      }});
      EXPECT_EQ(progress, 1);
      EXPECT_EQ(last_swaps, 0u);
      EXPECT_EQ(discrete, result.energy);
      const Measures m = measure(result.points);
      EXPECT_GE(result.energy, m.energy - 1.0 / k);
      energy += m.energy / 3;
      delta += m.delta_mean / 3;
    }
    EXPECT_LT(energy, known + 0.003) << k;
    EXPECT_GT(energy, 1.03) << k;
    EXPECT_GT(delta, k == 64 ? 0.81 : 0.83);
  }
}

TEST(Ccvt, SameSeedSameBits) {
  const CcvtResult a = ccvt({200, 60, 3, {}, {}}), b = ccvt({200, 60, 3, {}, {}}),
                   c = ccvt({200, 60, 4, {}, {}});
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.swaps, b.swaps);
  EXPECT_NE(a.points, c.points);
}

/// Leads end with the sites at their centroids, every space point kept, and lower than the way without them.
TEST(Ccvt, LeadsGetPastWhereNoExchangeGains) {
  CcvtCells plain = random_cells(500, 16, 3).cells;
  CcvtCells led = plain;
  const auto before = all_space_points(led);
  optimise(plain);
  CcvtPace pace;
  pace.most_passes = 10;
  pace.lead = 1.8;
  EXPECT_LE(optimise(led, pace).passes, 10u);
  EXPECT_EQ(all_space_points(led), before);
  for (std::size_t i = 0; i < led.size(); ++i) {
    glm::dvec2 mean(0);
    for (std::uint32_t k = 0; k < 16; ++k) {
      const glm::dvec2 p = space_point(led, i, k), s = position(led.sites[i]);
      mean += glm::dvec2(wrapped(p.x - s.x), wrapped(p.y - s.y)) / 16.0;
    }
    EXPECT_NEAR(std::hypot(mean.x, mean.y), 0, 1e-9);
  }
  optimise(led);
  EXPECT_LT(energy_of(led), 0.99 * energy_of(plain));
}

/// |sum of exp(2 pi i f.x)|^2 / n: 1 on average for independent points, n for a lattice with f in its
/// reciprocal.
double power(const Points& points, glm::dvec2 f) {
  double re = 0, im = 0;
  for (const glm::dvec2& p : points) {
    re += std::cos(2 * M_PI * (f.x * p.x + f.y * p.y));
    im += std::sin(2 * M_PI * (f.x * p.x + f.y * p.y));
  }
  return (re * re + im * im) / static_cast<double>(points.size());
}

/// What the start was made of (an even lattice of sites, strata, cut lines) must not show in the end: at the
/// frequencies of such regular things the power is what it is at others of the same length.
TEST(Ccvt, ForgetsItsStart) {
  constexpr std::uint32_t kSites = 1024;
  const EvenLattice lattice = even_lattice(kSites).lattice;
  const double area = lattice.a.x * lattice.b.y - lattice.a.y * lattice.b.x;
  const glm::dvec2 ra(lattice.b.y / area, -lattice.b.x / area), rb(-lattice.a.y / area, lattice.a.x / area);
  std::vector<glm::dvec2> regular{{32, 0}, {0, 32}, {16, 0}, {0, 16}, {64, 0}, {0, 64}};
  for (const glm::dvec2 f : {ra, rb, ra + rb, ra - rb}) {
    for (const glm::dvec2 image : {f, glm::dvec2(-f.x, f.y), glm::dvec2(f.y, f.x), glm::dvec2(f.y, -f.x)}) {
      regular.emplace_back(std::round(image.x), std::round(image.y));
    }
  }
  std::vector<Points> sets;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) sets.push_back(generate("ccvt", {kSites, seed, 256}));
  const auto mean_power = [&](glm::dvec2 f) {
    double sum = 0;
    for (const Points& points : sets) sum += power(points, f);
    return sum / static_cast<double>(sets.size());
  };
  for (const glm::dvec2& f : regular) {
    double ring = 0;
    for (int k = 0; k < 16; ++k) {  // off the axes of symmetry
      const double angle = (k + 0.37) * M_PI / 16, length = std::hypot(f.x, f.y);
      ring += mean_power({std::round(length * std::cos(angle)), std::round(length * std::sin(angle))}) / 16;
    }
    // The power of one set is about exponentially distributed: the mean of 24 spreads by a fifth of itself.
    EXPECT_LT(mean_power(f), 2.2 * ring + 0.1) << f.x << ", " << f.y;
  }
}

}  // namespace
}  // namespace capcon
