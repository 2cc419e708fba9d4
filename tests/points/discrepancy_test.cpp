#include "points/discrepancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/hash.h"
#include "points/generators.h"
#include "points/measure.h"

namespace capcon {
namespace {

Points random_points(std::size_t n, std::uint64_t seed) {
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) points[i] = {uniform64(seed, 0, 2 * i), uniform64(seed, 0, 2 * i + 1)};
  return points;
}

double radical_inverse(unsigned i, unsigned base) {
  double value = 0, place = 1.0 / base;
  for (; i > 0; i /= base, place /= base) value += place * (i % base);
  return value;
}

/// Every box that ends at coordinates of points or at 1, closed and open, counted point by point: O(n^3).
double star_by_all_boxes(const Points& points) {
  std::vector<double> xs{1}, ys{1};
  for (const glm::dvec2& p : points) xs.push_back(p.x), ys.push_back(p.y);
  double worst = 0;
  for (const double x : xs) {
    for (const double y : ys) {
      int open = 0, closed = 0;
      for (const glm::dvec2& p : points) open += p.x < x && p.y < y, closed += p.x <= x && p.y <= y;
      const auto n = static_cast<double>(points.size());
      worst = std::max({worst, x * y - open / n, closed / n - x * y});
    }
  }
  return worst;
}

/// Midpoint rule over the corners of the boxes.
double l2_by_quadrature(const Points& points, int side) {
  double sum = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      const double x = (u + 0.5) / side, y = (v + 0.5) / side;
      int inside = 0;
      for (const glm::dvec2& p : points) inside += p.x < x && p.y < y;
      const double error = inside / static_cast<double>(points.size()) - x * y;
      sum += error * error;
    }
  }
  return std::sqrt(sum) / side;
}

/// Warnock's double sum as it is printed.
double l2_by_pairs(const Points& points) {
  const auto n = static_cast<double>(points.size());
  double single = 0, pairs = 0;
  for (const glm::dvec2& p : points) {
    single += (1 - p.x * p.x) * (1 - p.y * p.y);
    for (const glm::dvec2& q : points) pairs += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y));
  }
  return std::sqrt(1.0 / 9 - single / (2 * n) + pairs / (n * n));
}

TEST(StarDiscrepancy, OnePoint) {
  // The closed box up to the point holds too much by 1 - x y, the open ones beside it too little by max(x,
  // y).
  EXPECT_DOUBLE_EQ(star_discrepancy({{0.3, 0.8}}), 0.8);
  EXPECT_DOUBLE_EQ(star_discrepancy({{0.3, 0.4}}), 0.88);
  EXPECT_DOUBLE_EQ(star_discrepancy({{0, 0}}), 1);
  EXPECT_EQ(star_discrepancy({}), 0);
}

TEST(StarDiscrepancy, Grids) {
  for (const int m : {1, 2, 5, 16}) {
    Points corners, centres;
    for (int i = 0; i < m * m; ++i) {
      corners.emplace_back(double(i % m) / m, double(i / m) / m);
      centres.emplace_back((i % m + 0.5) / m, (i / m + 0.5) / m);
    }
    // Corners: the closed box up to the last point holds all, its area is (1 - 1/m)^2.
    // Centres: the closed box up to the last point, (1 - 1/2m)^2; the worst open box, 1 by 1/2m, lacks less.
    EXPECT_NEAR(star_discrepancy(corners), 1 - std::pow(1 - 1.0 / m, 2), 1e-14) << m;
    EXPECT_NEAR(star_discrepancy(centres), 1 - std::pow(1 - 0.5 / m, 2), 1e-14) << m;
  }
}

TEST(StarDiscrepancy, CoincidentPointsAndSharedCoordinates) {
  EXPECT_DOUBLE_EQ(star_discrepancy(Points(100, {0.5, 0.5})), 0.75);
  Points points;
  for (std::uint64_t i = 0; i < 60; ++i)
    points.emplace_back(std::floor(6 * uniform64(1, 2, i)) / 6, std::floor(5 * uniform64(1, 3, i)) / 5);
  EXPECT_NEAR(star_discrepancy(points), star_by_all_boxes(points), 1e-14);
}

TEST(StarDiscrepancy, AgreesWithAllBoxes) {
  for (std::size_t n = 1; n <= 24; ++n) {
    const Points points = random_points(n, 100 + n);
    EXPECT_NEAR(star_discrepancy(points), star_by_all_boxes(points), 1e-14) << n;
  }
  const Points strips = random_points(600, 7);  // several strips of the sweep
  EXPECT_NEAR(star_discrepancy(strips), star_by_all_boxes(strips), 1e-13);
  for (const unsigned base : {2u, 3u, 5u}) {  // Hammersley's points
    Points points;
    for (unsigned i = 0; i < 30; ++i) points.emplace_back(i / 30.0, radical_inverse(i, base));
    EXPECT_NEAR(star_discrepancy(points), star_by_all_boxes(points), 1e-14) << base;
  }
}

TEST(StarDiscrepancy, HammersleyAndOtherNets) {
  // n D* = m/3 + 13/9 - (-1)^m (4/9) 2^-m for the n = 2^m >= 4 points of Hammersley in base 2 (Halton and
  // Zaremba 1969; De Clerck 1986); m/3 + 19/9 bounds every (0, m, 2)-net in base 2. Random points exceed
  // that.
  for (const unsigned m : {2u, 3u, 4u, 6u, 7u, 8u, 10u}) {
    const unsigned n = 1u << m;
    Points hammersley;
    for (unsigned i = 0; i < n; ++i) hammersley.emplace_back(i / double(n), radical_inverse(i, 2));
    const double sign = m % 2 == 0 ? 1 : -1;
    EXPECT_NEAR(n * star_discrepancy(hammersley), m / 3.0 + 13.0 / 9 - sign * 4.0 / 9 / n, 1e-11) << m;
    const double bound = (m / 3.0 + 19.0 / 9) / n;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      EXPECT_LE(star_discrepancy(generate("sobol-owen", {.n = n, .seed = seed})), bound);
      if (m >= 8) {
        EXPECT_GT(star_discrepancy(random_points(n, seed)), bound);
      }
    }
  }
}

TEST(StarDiscrepancy, SameBitsForAnyNumberOfThreads) {
  const Points points = random_points(3000, 9);
  ::setenv("CAPCON_THREADS", "1", 1);
  const double one = star_discrepancy(points);
  ::setenv("CAPCON_THREADS", "5", 1);
  EXPECT_EQ(star_discrepancy(points), one);
  ::unsetenv("CAPCON_THREADS");
}

TEST(L2StarDiscrepancy, ClosedForms) {
  // One point at the origin: the integral of (1 - x y)^2 is 1 - 1/2 + 1/9; far off: that of (x y)^2 is 1/9.
  EXPECT_NEAR(l2_star_discrepancy({{0, 0}}), std::sqrt(11.0 / 18), 1e-15);
  EXPECT_NEAR(l2_star_discrepancy({{1 - 1e-15, 1 - 1e-15}}), 1.0 / 3, 1e-14);
  EXPECT_EQ(l2_star_discrepancy({}), 0);
}

TEST(L2StarDiscrepancy, AgreesWithQuadrature) {
  for (const std::size_t n : {1, 2, 5, 20}) {
    const Points points = random_points(n, 40 + n);
    EXPECT_NEAR(l2_star_discrepancy(points), l2_by_quadrature(points, 1000), 1e-3) << n;
  }
}

TEST(L2StarDiscrepancy, AgreesWithAllPairs) {
  for (const std::size_t n : {3, 64, 500}) {
    const Points points = random_points(n, n);
    EXPECT_NEAR(l2_star_discrepancy(points), l2_by_pairs(points), 1e-12) << n;
  }
  const Points twins(40, {0.25, 0.5});
  EXPECT_NEAR(l2_star_discrepancy(twins), l2_by_pairs(twins), 1e-12);
}

TEST(L2StarDiscrepancy, RandomPointsHaveTheirMean) {
  // E[D^2] = (1/n) integral of x y (1 - x y) = (1/4 - 1/9) / n.
  double squared = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    squared += std::pow(l2_star_discrepancy(random_points(100, seed)), 2) / 200;
  EXPECT_NEAR(squared * 100, 5.0 / 36, 0.03);
}

TEST(MeasureFully, LeavesOutWhatIsTooDear) {
  const Points points = random_points(50, 3);
  const Measures full = measure_fully(points, 50), part = measure_fully(points, 49);
  EXPECT_EQ(full.star, star_discrepancy(points));
  EXPECT_EQ(part.l2_star, l2_star_discrepancy(points));
  EXPECT_TRUE(std::isnan(part.star) && std::isnan(part.energy_ot));
  EXPECT_GE(full.energy_ot, full.energy);  // equal masses ask for more than nearest points
}

}  // namespace
}  // namespace capcon
