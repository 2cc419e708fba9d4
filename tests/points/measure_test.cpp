#include "points/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/hash.h"

namespace capcon {
namespace {

Points random_points(std::size_t n, std::uint64_t seed) {
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) points[i] = {uniform64(seed, 0, 2 * i), uniform64(seed, 0, 2 * i + 1)};
  return points;
}

double wrapped(double d) {
  return d - std::round(d);
}

double toroidal2(glm::dvec2 a, glm::dvec2 b) {
  const double x = wrapped(a.x - b.x), y = wrapped(a.y - b.y);
  return x * x + y * y;
}

/// Areas and second moments by counting the points of a fine grid: shares no code with the polygons.
struct Counted {
  std::vector<double> area;
  double energy = 0;
};
Counted count_cells(const Points& points, int side) {
  Counted counted{std::vector<double>(points.size(), 0.0), 0};
  const double weight = 1.0 / side / side;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 p((x + 0.5) / side, (y + 0.5) / side);
      std::size_t best = 0;
      double best2 = 2;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double d2 = toroidal2(p, points[i]);
        if (d2 < best2) best2 = d2, best = i;
      }
      counted.area[best] += weight;
      counted.energy += weight * best2;
    }
  }
  return counted;
}

double total_area(const std::vector<VoronoiCell>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0,
                         [](double sum, const VoronoiCell& cell) { return sum + cell.area; });
}

void expect_agrees_with_counting(const Points& points, int side = 400) {
  const auto cells = voronoi_cells(points);
  ASSERT_EQ(cells.size(), points.size());
  EXPECT_NEAR(total_area(cells), 1, 1e-12);
  const Counted counted = count_cells(points, side);
  double energy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    energy += cells[i].second_moment;
    // A boundary of length L crosses about 1.3 L side grid squares; each is off by less than one square.
    double length = 0;
    const auto& corners = cells[i].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      length += glm::distance(corners[k], corners[(k + 1) % corners.size()]);
    }
    EXPECT_NEAR(cells[i].area, counted.area[i], length / side + 1e-9) << "cell " << i;
  }
  EXPECT_NEAR(energy, counted.energy, 2e-5 + 2.0 / side / side);
}

TEST(Voronoi, OnePointOwnsTheSquare) {
  const auto cells = voronoi_cells({{0.3, 0.9}});
  EXPECT_DOUBLE_EQ(cells[0].area, 1);
  EXPECT_DOUBLE_EQ(cells[0].second_moment, 1.0 / 6);
  EXPECT_EQ(cells[0].corners.size(), 4u);
  EXPECT_NEAR(glm::length(cells[0].centroid), 0, 1e-15);
}

TEST(Voronoi, FewPointsMeetTheirOwnImages) {
  for (std::size_t n = 1; n <= 12; ++n) {
    SCOPED_TRACE(n);
    expect_agrees_with_counting(random_points(n, 10 + n));
  }
}

TEST(Voronoi, AgreesWithCounting) {
  expect_agrees_with_counting(random_points(100, 3), 500);
}

TEST(Voronoi, Collinear) {
  Points row, diagonal;
  for (int i = 0; i < 40; ++i) {
    row.emplace_back(uniform64(5, 1, i), 0.37);
    diagonal.emplace_back(row.back().x, row.back().x);
  }
  expect_agrees_with_counting(row);
  expect_agrees_with_counting(diagonal);
}

TEST(Voronoi, CoincidentPointsGiveTheCellToTheFirst) {
  Points points = random_points(20, 8);
  points.push_back(points[7]);
  points.push_back(points[7]);
  const auto cells = voronoi_cells(points);
  EXPECT_GT(cells[7].area, 0);
  EXPECT_EQ(cells[20].area, 0);
  EXPECT_EQ(cells[21].area, 0);
  EXPECT_TRUE(cells[20].corners.empty());
  EXPECT_NEAR(total_area(cells), 1, 1e-13);
  EXPECT_EQ(measure(points).delta_min, 0);
  EXPECT_EQ(measure(Points(5000, {0.5, 0.5})).delta_mean, 0);
}

TEST(Voronoi, NeighboursOneBitApart) {
  const double x = 0.7, next = std::nextafter(x, 1.0);
  const auto cells = voronoi_cells({{x, 0.5}, {next, 0.5}, {0.1, 5e-324}, {0.1, 0}});
  EXPECT_NEAR(total_area(cells), 1, 1e-12);
  EXPECT_GT(cells[0].area, 0.1);
  EXPECT_GT(cells[1].area, 0.1);
  EXPECT_EQ(cells[3].area, 0);  // closer than 2^-53 is coincident
}

// A crowd in one grid cell, a line, and loners: the areas must still add up, quickly.
TEST(Voronoi, ClusteredPoints) {
  for (const double size : {1e-2, 1e-5, 1e-9}) {
    Points points = random_points(20000, 4);
    for (std::size_t i = 0; i + 3 < points.size(); ++i) points[i] = 0.25 + size * points[i];
    EXPECT_NEAR(total_area(voronoi_cells(points)), 1, 1e-11) << size;
  }
  Points line = random_points(20000, 6);
  for (glm::dvec2& p : line) p.y = 0.5;
  const auto cells = voronoi_cells(line);
  EXPECT_NEAR(total_area(cells), 1, 1e-11);
  std::vector<double> xs;
  for (const glm::dvec2& p : line) xs.push_back(p.x);
  std::sort(xs.begin(), xs.end());
  for (std::size_t i = 0; i < line.size(); i += 997) {  // a strip from half way to half way
    const auto at = static_cast<std::size_t>(std::lower_bound(xs.begin(), xs.end(), line[i].x) - xs.begin());
    const double left = at > 0 ? xs[at - 1] : xs.back() - 1;
    const double right = at + 1 < xs.size() ? xs[at + 1] : xs[0] + 1;
    EXPECT_NEAR(cells[i].area, (right - left) / 2, 1e-12);
  }
}

TEST(Voronoi, TreeAndGridAgree) {
  // The same 300 points spread out (grid) and, scaled about one of them, as a crowd (tree): inner cells are
  // similar.
  const Points spread = random_points(300, 12);
  Points crowd;
  for (const glm::dvec2& p : spread) crowd.push_back(0.5 + 0x1p-6 * (p - 0.5));
  const auto large = voronoi_cells(spread);
  const auto small = voronoi_cells(crowd);
  int compared = 0;
  for (std::size_t i = 0; i < spread.size(); ++i) {
    if (std::max(std::abs(spread[i].x - 0.5), std::abs(spread[i].y - 0.5)) > 0.25) continue;
    EXPECT_NEAR(small[i].area * 0x1p12, large[i].area, 1e-9);
    EXPECT_NEAR(glm::distance(small[i].centroid * 64.0, large[i].centroid), 0, 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(Voronoi, CentroidIsThatOfTheCorners) {
  // Two points: the cells are rectangles 0.5 wide whose centre is 0.05 away from the site.
  const auto cells = voronoi_cells({{0.1, 0.2}, {0.5, 0.2}});
  EXPECT_NEAR(cells[0].area, 0.5, 1e-15);
  EXPECT_NEAR(cells[0].centroid.x, -0.05, 1e-15);
  EXPECT_NEAR(cells[1].centroid.x, 0.05, 1e-15);
  EXPECT_NEAR(cells[0].centroid.y, 0, 1e-15);
  // Rectangle a x b about its centre: a b (a^2 + b^2) / 12, then the parallel axis.
  EXPECT_NEAR(cells[0].second_moment, 0.5 * (0.25 + 1) / 12 + 0.5 * 0.05 * 0.05, 1e-15);
}

TEST(Measure, SquareLattice) {
  Points points;
  for (int i = 0; i < 256; ++i) points.emplace_back((i % 16 + 0.3) / 16, (i / 16 + 0.9) / 16);
  const Measures m = measure(points);
  EXPECT_EQ(m.n, 256u);
  EXPECT_NEAR(m.energy, (1.0 / 6) / (5 / (18 * std::sqrt(3.0))), 1e-12);
  EXPECT_NEAR(m.area_sd, 0, 1e-12);
  EXPECT_NEAR(m.delta_min, std::sqrt(std::sqrt(3.0) / 2), 1e-12);  // 1/16 over sqrt(2 / (sqrt 3 256))
  EXPECT_NEAR(m.delta_mean, m.delta_min, 1e-12);
}

TEST(Measure, NearlyHexagonalLattice) {
  // 56 x 97 is a convergent of 1 : sqrt 3 times two points a cell: rows offset by half a step.
  Points points;
  for (int y = 0; y < 97; ++y) {
    for (int x = 0; x < 56; ++x) {
      points.emplace_back((x + 0.25) / 56, (y + 0.25) / 97);
      points.emplace_back((x + 0.75) / 56, (y + 0.75) / 97);
    }
  }
  const Measures m = measure(points);
  EXPECT_NEAR(m.energy, 1, 1e-6);
  EXPECT_GE(m.energy, 1 - 1e-12);
  EXPECT_NEAR(m.delta_min, 1, 1e-3);
  EXPECT_LT(m.delta_min, 1);
}

TEST(Measure, RandomPoints) {
  // Poisson-Voronoi: E[second moment] = integral of |x|^2 exp(-n pi |x|^2) n dx = 1 / (n pi), so n E = 1/pi;
  // the mean nearest distance is 1 / (2 sqrt n), and the variance of n area is 0.2802 (Gilbert 1962).
  double energy = 0, delta = 0, area_variance = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Measures m = measure(random_points(1024, seed));
    energy += m.energy / 20;
    delta += m.delta_mean / 20;
    area_variance += m.area_sd * m.area_sd / 20;
  }
  EXPECT_NEAR(energy, 1 / M_PI / kHexagonEnergy, 0.03);  // 1.985
  EXPECT_NEAR(delta, 0.5 / std::sqrt(2 / std::sqrt(3.0)), 0.01);
  EXPECT_NEAR(area_variance, 0.2802, 0.02);
}

TEST(Measure, NearestDistancesAgreeWithAllPairs) {
  for (const std::size_t n : {2, 3, 5, 17, 400}) {
    const Points points = random_points(n, 77);
    double smallest = 1, sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double nearest = 1;
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i) nearest = std::min(nearest, std::sqrt(toroidal2(points[i], points[j])));
      }
      smallest = std::min(smallest, nearest);
      sum += nearest;
    }
    const double hexagonal = std::sqrt(2 / (std::sqrt(3.0) * static_cast<double>(n)));
    EXPECT_NEAR(measure(points).delta_min, smallest / hexagonal, 1e-12);
    EXPECT_NEAR(measure(points).delta_mean, sum / static_cast<double>(n) / hexagonal, 1e-12);
  }
}

TEST(Measure, CapacityErrorAndCentroids) {
  // Two cells 0.5 wide with sites 0.05 off their middles (see above): d_hex = sqrt(1 / sqrt 3).
  const Measures even = measure({{0.1, 0.2}, {0.5, 0.2}});
  EXPECT_NEAR(even.centroid_rms, 0.05 / std::sqrt(1 / std::sqrt(3.0)), 1e-14);
  EXPECT_NEAR(even.capacity_error, 0, 1e-28);
  // Three in a row at 0, 0.1, 0.5: widths 0.3, 0.25, 0.45.
  const Measures row = measure({{0, 0.2}, {0.1, 0.2}, {0.5, 0.2}});
  const double expected =
      (std::pow(3 * 0.3 - 1, 2) + std::pow(3 * 0.25 - 1, 2) + std::pow(3 * 0.45 - 1, 2)) / 3;
  EXPECT_NEAR(row.capacity_error, expected, 1e-14);
  EXPECT_NEAR(row.area_sd * row.area_sd, row.capacity_error, 1e-15);
}

TEST(Measure, BondOrder) {
  Points hexagons, squares;
  for (int y = 0; y < 97; ++y) {
    for (int x = 0; x < 56; ++x) {
      hexagons.emplace_back((x + 0.25) / 56, (y + 0.25) / 97);
      hexagons.emplace_back((x + 0.75) / 56, (y + 0.75) / 97);
    }
  }
  for (int i = 0; i < 400; ++i) squares.emplace_back((i % 20 + 0.5) / 20, (i / 20 + 0.5) / 20);
  EXPECT_NEAR(measure(hexagons).psi6, 1, 1e-3);
  EXPECT_NEAR(measure(hexagons).psi6_local, 1, 1e-3);
  EXPECT_NEAR(measure(squares).psi6_local, 0, 1e-9);  // sixfold turns of 0, 90, 180, 270 degrees cancel
  const Measures random = measure(random_points(20000, 2));
  EXPECT_LT(random.psi6, 0.02);  // no common direction
  EXPECT_NEAR(random.psi6_local, 0.4, 0.1);
}

TEST(Measure, MeansOfSets) {
  const std::vector<Measures> all{measure(random_points(100, 1)), measure(random_points(100, 2))};
  const Measures mean = mean_of(all);
  EXPECT_EQ(mean.n, 100u);
  EXPECT_DOUBLE_EQ(mean.psi6_local, (all[0].psi6_local + all[1].psi6_local) / 2);
  EXPECT_FALSE(to_json(mean).contains("star"));
  EXPECT_EQ(mean_of({all[0], measure({{0.5, 0.5}})}).n, 0u);
}

TEST(Measure, SmallestCases) {
  EXPECT_EQ(measure({}).n, 0u);
  EXPECT_NEAR(measure({{0.5, 0.5}}).delta_min, 1 / std::sqrt(2 / std::sqrt(3.0)), 1e-15);
  EXPECT_NEAR(measure({{0.5, 0.5}}).energy, 1.0 / 6 / kHexagonEnergy, 1e-14);
  EXPECT_EQ(to_json(measure({{0.5, 0.5}})).at("n"), 1);
}

}  // namespace
}  // namespace capcon
