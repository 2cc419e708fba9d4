#include "points/lattice_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "points/measure.h"

namespace capcon {
namespace {

/// By all n points, no theory.
std::uint64_t shortest2_by_search(std::int64_t n, std::int64_t g) {
  std::int64_t best = n * n;
  for (std::int64_t k = 1; k < n; ++k) {
    const std::int64_t y = k * g % n, dx = std::min(k, n - k), dy = std::min(y, n - y);
    best = std::min(best, dx * dx + dy * dy);
  }
  return static_cast<std::uint64_t>(best);
}

TEST(LatticePoints, GeneratorIsTheBestOfAll) {
  for (std::uint32_t n = 1; n < 260; ++n) {
    std::uint64_t best = 0;
    std::uint32_t best_g = 0;
    for (std::uint32_t g = 0; g <= n / 2; ++g) {
      const std::uint64_t length2 = shortest2_by_search(n, g);
      if (length2 > best) best = length2, best_g = g;
    }
    const std::uint32_t found = maximin_generator(n);
    EXPECT_EQ(shortest2_by_search(n, found), best) << n;
    if (n > 1) {
      EXPECT_EQ(found, best_g) << n;
    }
  }
}

TEST(LatticePoints, MaximinHasThePublishedMeasures) {
  const Measures m = measure(lattice_points(LatticeKind::kMaximin, 1024));
  EXPECT_NEAR(m.delta_min, 0.990, 0.0006);
  EXPECT_NEAR(m.delta_mean, m.delta_min, 1e-9);
  EXPECT_NEAR(m.energy, 1.0001, 0.00006);
  EXPECT_NEAR(m.area_sd, 0, 1e-9);
  // Dense packings exist for all large n.
  EXPECT_GT(measure(lattice_points(LatticeKind::kMaximin, 99991)).delta_min, 0.995);
}

TEST(LatticePoints, GoldenHasThePublishedMeasures) {
  const Measures m = measure(lattice_points(LatticeKind::kGolden, 1024));
  EXPECT_NEAR(m.delta_min, 0.388, 0.0006);
  EXPECT_NEAR(m.energy, 1.0256, 0.0006);
  EXPECT_NEAR(m.area_sd, 0.031, 0.0006);
  const Points points = lattice_points(LatticeKind::kGolden, 5000);
  for (int k = 0; k < 5000; ++k) {
    const double y = std::fmod(k * 0.6180339887498949, 1.0);
    ASSERT_NEAR(points[k].x, k / 5000., 1e-15);
    ASSERT_NEAR(points[k].y, y, 1e-12);
  }
}

TEST(LatticePoints, ShiftKeepsAllDifferences) {
  const Points points = lattice_points(LatticeKind::kMaximin, 100);
  Points moved = points, again = points, other = points;
  shift_randomly(moved, 4);
  shift_randomly(again, 4);
  shift_randomly(other, 5);
  EXPECT_EQ(moved, again);
  EXPECT_NE(moved, other);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec2 d = (moved[k] - points[k]) - (moved[0] - points[0]);
    EXPECT_NEAR(d.x, std::round(d.x), 1e-12);
    EXPECT_NEAR(d.y, std::round(d.y), 1e-12);
    EXPECT_TRUE(moved[k].x >= 0 && moved[k].x < 1 && moved[k].y >= 0 && moved[k].y < 1);
  }
}

}  // namespace
}  // namespace capcon
