#include "points/ensemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "base/error.h"
#include "base/hash.h"

namespace capcon {
namespace {

TEST(Ensemble, DealsEveryCellOnce) {
  for (const std::uint32_t n : {1u, 2u, 3u, 7u, 16u, 20u, 31u, 64u, 96u}) {
    const Ensemble e = make_ensemble({.points = n, .effort = 1e6});
    EXPECT_EQ(e.cells.size(), std::size_t(e.sets) * n) << n;
    EXPECT_EQ(e.cells.size(), std::size_t(e.columns) * e.rows) << n;
    EXPECT_EQ(std::set<std::uint32_t>(e.cells.begin(), e.cells.end()).size(), e.cells.size()) << n;
    EXPECT_LT(*std::max_element(e.cells.begin(), e.cells.end()), e.cells.size()) << n;
    EXPECT_GE(e.sets, 31u) << n;
    EXPECT_LE(double(std::max(e.columns, e.rows)) / std::min(e.columns, e.rows), 1.25) << n;
  }
}

// The mean distance of two points of the unit disk is 128 / (45 pi), of the unit square (2 + sqrt 2 + 5 asinh
// 1) / 15. An even set of n lies below by about 0.5 n^-1.5 (what half-planes cannot balance); a random one by
// 1/n of it.
TEST(Ensemble, SetsComeNearTheDomainsMeanDistance) {
  const double disk = 128 / (45 * std::numbers::pi), square = (2 + std::sqrt(2.0) + 5 * std::asinh(1.0)) / 15;
  for (const std::uint32_t n : {8u, 16u, 64u}) {
    const Ensemble d = make_ensemble({.points = n, .domain = EnsembleDomain::disk});
    const Ensemble s = make_ensemble({.points = n, .domain = EnsembleDomain::square});
    const double below_disk = (disk - mean_distance_within(d, EnsembleDomain::disk)) / disk;
    const double below_square = (square - mean_distance_within(s, EnsembleDomain::square)) / square;
    EXPECT_GT(below_disk, 0) << n;
    EXPECT_LT(below_disk, 0.7 * std::pow(n, -1.5)) << n;
    EXPECT_GT(below_square, 0) << n;
    EXPECT_LT(below_square, 0.8 * std::pow(n, -1.5)) << n;
  }
}

TEST(Ensemble, SameForAnyNumberOfThreads) {
  std::vector<std::uint32_t> first;
  for (const char* threads : {"1", "3"}) {
    ::setenv("CAPCON_THREADS", threads, 1);
    const Ensemble e = make_ensemble({.points = 100, .seed = 7, .effort = 2e7});
    if (first.empty()) first = e.cells;
    EXPECT_EQ(e.cells, first);
  }
  ::unsetenv("CAPCON_THREADS");
}

// Circles are rims of squares, and areas keep their ratio: Shirley and Chiu 1997.
TEST(Ensemble, TheDiskIsReachedByTheConcentricMap) {
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 u(uniform64(1, i, 0), uniform64(1, i, 1)), p = into_domain(EnsembleDomain::disk, u);
    EXPECT_NEAR(std::hypot(p.x, p.y), std::max(std::abs(2 * u.x - 1), std::abs(2 * u.y - 1)), 1e-12);
    const double h = 1e-6;
    const glm::dvec2 dx = (into_domain(EnsembleDomain::disk, u + glm::dvec2(h, 0)) - p) / h;
    const glm::dvec2 dy = (into_domain(EnsembleDomain::disk, u + glm::dvec2(0, h)) - p) / h;
    EXPECT_NEAR(std::abs(dx.x * dy.y - dx.y * dy.x), std::numbers::pi, 2e-4);
  }
}

TEST(Ensemble, RefusesWhatItCannotMake) {
  EXPECT_THROW(make_ensemble({.points = 0}), InputError);
  EXPECT_THROW(make_ensemble({.points = 1025}), InputError);
}

}  // namespace
}  // namespace capcon
