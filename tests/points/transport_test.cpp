#include "points/transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "points/generators.h"
#include "points/measure.h"

namespace capcon {
namespace {

double squared(glm::dvec2 a, glm::dvec2 b) {
  const double x = a.x - b.x - std::round(a.x - b.x), y = a.y - b.y - std::round(a.y - b.y);
  return x * x + y * y;
}

/// The least cost of giving each row of a square matrix a column of its own: shortest augmenting paths with
/// potentials (the Hungarian method of Kuhn, in the form of Jonker and Volgenant), O(m^3).
double assignment_cost(const std::vector<std::vector<double>>& cost) {
  const std::size_t m = cost.size();
  std::vector<double> u(m + 1, 0), v(m + 1, 0);
  std::vector<std::size_t> row_of(m + 1, 0), way(m + 1, 0);
  for (std::size_t i = 1; i <= m; ++i) {
    row_of[0] = i;
    std::size_t j = 0;
    std::vector<double> least(m + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> used(m + 1, false);
    do {
      used[j] = true;
      const std::size_t row = row_of[j];
      double step = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t k = 1; k <= m; ++k) {
        if (used[k]) continue;
        const double reduced = cost[row - 1][k - 1] - u[row] - v[k];
        if (reduced < least[k]) least[k] = reduced, way[k] = j;
        if (least[k] < step) step = least[k], next = k;
      }
      for (std::size_t k = 0; k <= m; ++k) {
        if (used[k])
          u[row_of[k]] += step, v[k] -= step;
        else
          least[k] -= step;
      }
      j = next;
    } while (row_of[j] != 0);
    for (; j != 0; j = way[j]) row_of[j] = row_of[way[j]];
  }
  double sum = 0;
  for (std::size_t j = 1; j <= m; ++j) sum += cost[row_of[j] - 1][j - 1];
  return sum;
}

/// E_ot from above: the squares of a grid, whole, shared out among the points at least cost. Too much only
/// where the true cells' borders cut squares.
double discrete_energy(const Points& points, std::size_t side) {
  const std::size_t m = side * side, n = points.size();
  std::vector<std::vector<double>> cost(m, std::vector<double>(m));
  for (std::size_t g = 0; g < m; ++g) {
    const glm::dvec2 p((static_cast<double>(g % side) + 0.5) / static_cast<double>(side),
                       (static_cast<double>(g / side) + 0.5) / static_cast<double>(side));
    for (std::size_t k = 0; k < m; ++k) cost[g][k] = squared(p, points[k % n]);
  }
  const double mean = assignment_cost(cost) / static_cast<double>(m) + 1.0 / 6 / static_cast<double>(m);
  return static_cast<double>(n) * mean / kHexagonEnergy;
}

TEST(TransportEnergy, AgreesWithADiscreteAssignment) {
  for (const std::uint32_t n : {1u, 2u, 3u, 4u, 6u, 9u}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Points points = generate("random", {n, seed});
      const double ratio = transport_energy(points) / discrete_energy(points, 18);
      EXPECT_LE(ratio, 1 + 1e-12) << n << " " << seed;
      EXPECT_GE(ratio, 0.975) << n << " " << seed;
    }
  }
}

TEST(TransportEnergy, KnowsClosedForms) {
  EXPECT_DOUBLE_EQ(transport_energy({}), 0);
  const double square = 1.0 / 6 / kHexagonEnergy;
  EXPECT_NEAR(transport_energy({{0.3, 0.9}}), square, 1e-12);
  Points grid;
  for (int i = 0; i < 49; ++i) grid.emplace_back(i % 7 / 7.0, i / 7 / 7.0);
  EXPECT_NEAR(transport_energy(grid), square, 1e-11);
  // Two points a apart along x: slabs of width 1/2 whose centroids are 1/2 apart. Per slab: 1/4 across and 1
  // along, and the square of the distance to the centroid, the half of (1/2 - a).
  for (const double a : {0.5, 0.3, 0.01}) {
    const double mean = 0.25 / 12 + 1.0 / 12 + 0.25 * (0.5 - a) * (0.5 - a);
    EXPECT_NEAR(transport_energy({{0.9, 0.2}, {std::fmod(0.9 + a, 1.0), 0.2}}), 2 * mean / kHexagonEnergy,
                1e-9)
        << a;
  }
  // k points in one place are one of k masses: the lowest cost is that of one point each, times k.
  const Points one = generate("random", {40, 5});
  Points thrice;
  for (int k = 0; k < 3; ++k) thrice.insert(thrice.end(), one.begin(), one.end());
  EXPECT_NEAR(transport_energy(thrice), 3 * transport_energy(one), 1e-8);
  EXPECT_NEAR(transport_energy(Points(17, {0.25, 0.999})), 17 * square, 1e-10);
}

TEST(TransportEnergy, AgreesWithPublishedSets) {
  // Means of three seeds at n = 1024, measured with other code: random 4.44, jittered 1.528,
  // Owen-scrambled 1.3615.
  const auto mean = [](const char* method) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      sum += transport_energy(generate(method, {1024, seed})) / 3;
    return sum;
  };
  EXPECT_NEAR(mean("random"), 4.44, 0.4);
  EXPECT_NEAR(mean("jittered"), 1.528, 0.04);
  EXPECT_NEAR(mean("sobol-owen"), 1.3615, 0.03);
}

/// Points crowded in a corner, on a line, on a circle, and nearly coincident ones.
TEST(TransportEnergy, StandsHardInput) {
  Points corner, line, circle;
  for (int i = 0; i < 200; ++i) {
    const double u = uniform64(1, 2, 2 * i), v = uniform64(1, 2, 2 * i + 1), angle = 2 * M_PI * i / 200;
    corner.emplace_back(0.01 * u, 0.01 * v);
    line.emplace_back(u, 0.5);
    circle.emplace_back(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
  }
  // All mass at about (0.005, 0.005): 1/6, but for what the spread of the points saves.
  EXPECT_NEAR(transport_energy(corner) / (200 / 6.0 / kHexagonEnergy), 1, 0.02);
  EXPECT_LT(transport_energy(corner) / (200 / 6.0 / kHexagonEnergy), 1);
  // Everything has to go to y = 1/2: at least 1/12 a point.
  EXPECT_GT(transport_energy(line), 200 / 12.0 / kHexagonEnergy);
  EXPECT_LT(transport_energy(line), 1.05 * 200 / 12.0 / kHexagonEnergy);
  EXPECT_TRUE(std::isfinite(transport_energy(circle)));
  Points close = generate("jittered", {100, 3});
  const double before = transport_energy(close);
  close[7] = close[8] + glm::dvec2(1e-9, 0);
  EXPECT_NEAR(transport_energy(close), before, 0.1);
  close[7] = close[8] + glm::dvec2(1e-6, 0);
  EXPECT_NEAR(transport_energy(close), before, 0.1);
}

TEST(TransportEnergy, DoesNotDependOnOrderOrPlace) {
  Points points = generate("random", {300, 8});
  const double energy = transport_energy(points);
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(transport_energy(points), energy, 1e-9 * energy);
  for (glm::dvec2& p : points) p = {std::fmod(p.x + 0.37, 1.0), std::fmod(p.y + 0.81, 1.0)};
  EXPECT_NEAR(transport_energy(points), energy, 1e-9 * energy);
}

// From weights of 0 all cells but those at the rim begin next to empty: Newton's steps stood still there.
TEST(TransportEnergy, OfOneTinyClusterIsThatOfOnePlace) {
  for (const double width : {1e-3, 1e-5, 1e-6}) {
    for (const double corner : {0.5, 1 - 0.3 * width}) {  // over the seam too
      Points points;
      for (std::uint64_t i = 0; i < 127; ++i) {
        const glm::dvec2 p =
            corner + width * glm::dvec2(uniform64(1, 127, 2 * i), uniform64(1, 127, 2 * i + 1));
        points.push_back(p - glm::floor(p));
      }
      EXPECT_NEAR(transport_energy(points) / (127 / 6.0 / kHexagonEnergy), 1, 2 * width) << width;
    }
  }
}

TEST(TransportEnergy, IsLeftOutOfTheMeasuresWhereItCannotBeFound) {
  Points points;  // two clusters, 1e-6 wide and 1e-11 high
  for (std::uint64_t i = 0; i < 127; ++i) {
    points.emplace_back(0.3 * static_cast<double>(i % 2 + 1) + 1e-6 * uniform64(0, 127, 2 * i),
                        0.5 + 1e-11 * uniform64(0, 127, 2 * i + 1));
  }
  const Measures measures = measure_fully(points);
  EXPECT_TRUE(std::isfinite(measures.energy) && std::isfinite(measures.star));
  EXPECT_THROW(transport_energy(points), Failure);
  EXPECT_TRUE(std::isnan(measures.energy_ot));
}

}  // namespace
}  // namespace capcon
