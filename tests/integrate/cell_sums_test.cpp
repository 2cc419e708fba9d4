#include "integrate/cell_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "base/hash.h"
#include "points/generators.h"
#include "points/measure.h"

namespace capcon::integrate {
namespace {

CellSums square_of(const Points& points) {
  return square_sums(points, torus_cells(points));
}

double sum(const std::vector<double>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0);
}

TEST(CellSums, TorusCellsAreThoseOfTheMeasures) {
  const Points points = generate("random", {.n = 200, .seed = 4});
  const CellSums sums = torus_sums(torus_cells(points));
  EXPECT_NEAR(sum(sums.areas), 1, 1e-12);
  EXPECT_NEAR(200 * sums.energy / kHexagonEnergy, measure(points).energy, 1e-10);
}

// Against a fine grid whose places are given to the nearest point without any wrap; few and many points, one
// in a corner.
TEST(CellSums, SquareCellsAgreeWithAGrid) {
  constexpr int kSide = 600;
  for (const std::uint32_t n : {1u, 2u, 3u, 10u, 100u}) {
    Points points = generate("random", {.n = n, .seed = 9});
    if (n == 10) points[0] = {0, 0};
    CellSums expected{std::vector<double>(n), 0, 0};
    std::vector<glm::dvec2> first(n);
    for (int i = 0; i < kSide * kSide; ++i) {
      const glm::dvec2 x((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
      std::size_t nearest = 0;
      for (std::size_t k = 1; k < n; ++k) {
        if (glm::distance(x, points[k]) < glm::distance(x, points[nearest])) nearest = k;
      }
      constexpr double kArea = 1.0 / (kSide * kSide);
      expected.areas[nearest] += kArea;
      expected.energy += kArea * glm::dot(x - points[nearest], x - points[nearest]);
      first[nearest] += kArea * (x - points[nearest]);
    }
    for (const glm::dvec2& v : first) expected.off_centre += glm::length(v);
    const CellSums sums = square_of(points);
    EXPECT_NEAR(sum(sums.areas), 1, 1e-12) << n;
    for (std::size_t k = 0; k < n; ++k)
      EXPECT_NEAR(sums.areas[k], expected.areas[k], 2e-4) << n << " point " << k;
    EXPECT_NEAR(sums.energy / expected.energy, 1, 1e-3) << n;
    EXPECT_NEAR(sums.off_centre / expected.off_centre, 1, 2e-3) << n;
  }
}

// Clumps and a far point: cells reach over the whole square, where images on the torus would cut them.
TEST(CellSums, SquareCellsOfClumpsFillTheSquare) {
  for (const glm::dvec2 clump : {glm::dvec2(0.01, 0.01), glm::dvec2(0.5, 0.98), glm::dvec2(0.3, 0.6)}) {
    Points points = generate("random", {.n = 50, .seed = 2});
    for (glm::dvec2& p : points) p = clump + 0.01 * p;
    points.push_back({0.99, 0.02});
    EXPECT_NEAR(sum(square_of(points).areas), 1, 1e-12);
  }
}

// The lattice of k x k cell centres: all is known. Its cells do not care for the torus.
TEST(CellSums, GridIsCentroidal) {
  Points points;
  for (int i = 0; i < 64; ++i) points.emplace_back((i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8);
  for (const CellSums& sums : {square_of(points), torus_sums(torus_cells(points))}) {
    for (const double area : sums.areas) EXPECT_NEAR(area, 1.0 / 64, 1e-14);
    EXPECT_NEAR(64 * sums.energy, 1.0 / 6, 1e-12);
    EXPECT_NEAR(sums.off_centre, 0, 1e-14);
  }
}

// Neither term can be smaller: one point in the square's centre and f = |x - x_0|^2 reach the first with M =
// 2; one elsewhere and f = x, where M = 0, reach the second.
TEST(CellSums, SecondDerivativeBoundIsReached) {
  EXPECT_NEAR(second_derivative_bound(square_of({{0.5, 0.5}}), 1, 2), 1.0 / 6, 1e-12);
  EXPECT_NEAR(second_derivative_bound(square_of({{0.2, 0.5}}), 1, 0), 0.3, 1e-12);
}

}  // namespace
}  // namespace capcon::integrate
