#include "points/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/error.h"
#include "points/bounded_cells.h"
#include "points/generators.h"
#include "points/lloyd.h"
#include "points/region_ccvt.h"

namespace capcon {
namespace {

std::shared_ptr<const Density> density_of(const std::function<double(double, double)>& f,
                                          std::size_t side = 128) {
  return std::make_shared<Density>(Density::of(f, side));
}

double squared(glm::dvec2 a, glm::dvec2 b, bool torus) {
  glm::dvec2 d = a - b;
  if (torus) d = {d.x - std::round(d.x), d.y - std::round(d.y)};
  return d.x * d.x + d.y * d.y;
}

TEST(Region, DiskMapKeepsAreas) {
  // A fine grid: the share that falls into a ring or a sector is its share of the area.
  std::map<int, int> rings, sectors;
  const int side = 1000;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::dvec2 p = to_disk({(i + 0.5) / side, (j + 0.5) / side}) - 0.5;
      const double r = 2 * std::hypot(p.x, p.y);
      ASSERT_LE(r, 1);
      ++rings[static_cast<int>(r * r * 5)];
      ++sectors[static_cast<int>((std::atan2(p.y, p.x) + M_PI) / (2 * M_PI) * 7)];
    }
  }
  for (const auto& [ring, count] : rings) EXPECT_NEAR(count, side * side / 5., 2 * side) << ring;
  for (const auto& [sector, count] : sectors) EXPECT_NEAR(count, side * side / 7., 2 * side) << sector;
  for (const double u : {0., 0.5, 1 - 0x1p-53}) {
    for (const double v : {0., 0.5, 1 - 0x1p-53}) {
      const glm::dvec2 p = to_disk({u, v});
      EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      EXPECT_LE(std::hypot(p.x - 0.5, p.y - 0.5), 0.5 + 1e-15);
    }
  }
}

TEST(Region, BoundedCellsAgreeWithCounting) {
  for (const Domain domain : {Domain::kSquare, Domain::kDisk}) {
    for (const std::uint32_t n : {1u, 2u, 7u, 40u}) {
      const Points points = random_points({domain, {}}, n, 3);
      const auto cells = bounded_cells(points, domain);
      std::vector<double> area(n, 0);
      std::vector<glm::dvec2> moment(n, glm::dvec2(0));
      const int side = 1500;
      for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
          const glm::dvec2 z((i + 0.5) / side, (j + 0.5) / side);
          if (domain == Domain::kDisk && std::hypot(z.x - 0.5, z.y - 0.5) > 0.5) continue;
          std::size_t best = 0;
          for (std::size_t k = 1; k < n; ++k) {
            if (squared(z, points[k], false) < squared(z, points[best], false)) best = k;
          }
          area[best] += 1. / (side * side);
          moment[best] += z / static_cast<double>(side * side);
        }
      }
      double total = 0;
      for (std::size_t k = 0; k < n; ++k) {
        total += cells[k].area;
        EXPECT_NEAR(cells[k].area, area[k], 4e-4) << n << " " << k;
        EXPECT_NEAR(cells[k].centroid.x, moment[k].x / area[k], 2e-3);
        EXPECT_NEAR(cells[k].centroid.y, moment[k].y / area[k], 2e-3);
      }
      EXPECT_NEAR(total, domain == Domain::kDisk ? M_PI / 4 : 1, 1e-12);
    }
  }
}

TEST(Region, SpreadHoldsTheMassEverywhere) {
  const auto f = [](double x, double y) { return 0.1 + x * x + (y > 0.5 ? 2 : 0); };
  for (const Domain domain : {Domain::kTorus, Domain::kSquare, Domain::kDisk}) {
    const std::uint64_t m = 40000;
    const Points points = spread({domain, density_of(f)}, m, 1);
    ASSERT_EQ(points.size(), m);
    // Mass of 8 x 8 boxes by midpoints.
    std::map<int, double> mass, count;
    double total = 0;
    for (int j = 0; j < 1024; ++j) {
      for (int i = 0; i < 1024; ++i) {
        const double x = (i + 0.5) / 1024, y = (j + 0.5) / 1024;
        if (domain == Domain::kDisk && !is_in_disk({x, y})) continue;
        mass[j / 128 * 8 + i / 128] += f(x, y);
        total += f(x, y);
      }
    }
    for (const glm::dvec2& p : points) {
      ASSERT_TRUE(domain != Domain::kDisk || is_in_disk(p));
      ++count[static_cast<int>(p.y * 8) * 8 + static_cast<int>(p.x * 8)];
    }
    // Independent points would err by about 25.
    for (const auto& [box, expected] : mass) EXPECT_NEAR(count[box], expected / total * m, 15) << box;
  }
}

/// No pair of space points can be exchanged with a gain, each site is the centroid of its own.
void expect_settled(const RegionCells& cells, std::uint32_t capacity, bool torus, double scale) {
  const std::size_t n = cells.sites.size();
  ASSERT_EQ(cells.space_points.size(), n * capacity);
  std::vector<std::vector<double>> most(n,
                                        std::vector<double>(n, -1e9));  // largest gain of a move from i to j
  for (std::size_t i = 0; i < n; ++i) {
    glm::dvec2 sum(0);
    for (std::size_t k = i * capacity; k < (i + 1) * capacity; ++k) {
      glm::dvec2 d = cells.space_points[k] - cells.sites[i];
      if (torus) d = {d.x - std::round(d.x), d.y - std::round(d.y)};
      sum += d;
      for (std::size_t j = 0; j < n; ++j) {
        const double gain = squared(cells.space_points[k], cells.sites[i], torus) -
                            squared(cells.space_points[k], cells.sites[j], torus);
        most[i][j] = std::max(most[i][j], gain);
      }
    }
    EXPECT_LT(std::hypot(sum.x, sum.y) / capacity, 1e-9 * scale);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_LT(most[i][j] + most[j][i], 1e-5 * scale * scale) << i << " " << j;
  }
}

TEST(RegionCcvt, CellsHoldTheirShareAndAreSettled) {
  const std::shared_ptr<const Density> slope = density_of([](double x, double y) { return x + 3 * y * y; });
  for (const Region& region :
       {Region{Domain::kSquare, {}}, Region{Domain::kDisk, {}}, Region{Domain::kTorus, slope},
        Region{Domain::kSquare, slope}, Region{Domain::kDisk, slope}}) {
    for (const std::uint32_t n : {1u, 2u, 3u, 60u}) {
      for (const std::uint32_t capacity : {1u, 16u, 100u}) {
        CcvtOptions options;
        options.sites = n;
        options.capacity = capacity;
        const RegionCells cells = region_ccvt_cells(region, options);
        expect_settled(cells, capacity, region.domain == Domain::kTorus, 1);
        for (const glm::dvec2& p : cells.sites) {
          EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
          EXPECT_TRUE(region.domain != Domain::kDisk || is_in_disk(p));
        }
      }
    }
  }
}

/// n E over the domain of area A, in units of hexagons, by brute force with cells of the nearest site.
double bounded_energy(const Points& points, Domain domain) {
  const int side = 700;
  double sum = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::dvec2 z((i + 0.5) / side, (j + 0.5) / side);
      if (domain == Domain::kDisk && !is_in_disk(z)) continue;
      double best = 9;
      for (const glm::dvec2& p : points) best = std::min(best, squared(z, p, false));
      sum += best / (side * side);
    }
  }
  const double area = domain == Domain::kDisk ? M_PI / 4 : 1;
  return static_cast<double>(points.size()) * sum / (area * area) / 0.160375;
}

TEST(RegionCcvt, BoundedEnergyIsNearTheLeast) {
  for (const Domain domain : {Domain::kSquare, Domain::kDisk}) {
    GeneratorOptions options;
    options.n = 64;
    options.capacity = 256;
    options.region.domain = domain;
    const double ccvt = bounded_energy(generate("ccvt", options), domain);
    const double lloyd = bounded_energy(generate("lloyd", options), domain);
    const double random = bounded_energy(generate("random", options), domain);
    EXPECT_LT(ccvt, 1.08);
    EXPECT_LT(lloyd, ccvt + 0.01);
    EXPECT_GT(lloyd, 1);
    EXPECT_GT(random, 1.5);
  }
}

TEST(RegionCcvt, CentroidsKeepTheDomainsCentroid) {
  // Equal capacities make the mean of the sites the mean of the mass: exact for any domain.
  CcvtOptions options;
  options.sites = 50;
  options.capacity = 64;
  const auto mean = [&](const Region& region) {
    glm::dvec2 sum(0);
    for (const glm::dvec2& p : region_ccvt(region, options)) sum += p / 50.;
    return sum;
  };
  for (const Domain domain : {Domain::kSquare, Domain::kDisk}) {
    EXPECT_NEAR(mean({domain, {}}).x, 0.5, 5e-4);
    EXPECT_NEAR(mean({domain, {}}).y, 0.5, 5e-4);
  }
  const glm::dvec2 slope = mean({Domain::kSquare, density_of([](double x, double) { return x; })});
  EXPECT_NEAR(slope.x, 2. / 3, 5e-4);
  EXPECT_NEAR(slope.y, 0.5, 5e-4);
}

TEST(RegionCcvt, StiffDensitiesEndWell) {
  CcvtOptions options;
  options.sites = 100;
  options.capacity = 64;
  std::vector<double> spot(256 * 256, 0);
  spot[100 * 256 + 77] = 3;
  const auto one_texel = std::make_shared<Density>(256, 256, spot);
  for (const Domain domain : {Domain::kTorus, Domain::kSquare, Domain::kDisk}) {
    const RegionCells cells = region_ccvt_cells({domain, one_texel}, options);
    expect_settled(cells, 64, false, 1. / 256);
    for (const glm::dvec2& p : cells.sites) {
      EXPECT_TRUE(p.x > 77. / 256 && p.x < 78. / 256 && p.y > 100. / 256 && p.y < 101. / 256);
    }
  }
  // A millionth of the density all around a small square that holds 61/62 of... whatever it is, in exact
  // numbers:
  const auto steep = density_of([](double x, double y) { return x < 0.125 && y < 0.125 ? 1e6 : 1; }, 64);
  const double inside = 1e6 / 64 / (1e6 / 64 + 63. / 64);
  for (const Domain domain : {Domain::kTorus, Domain::kSquare}) {
    const RegionCells cells = region_ccvt_cells({domain, steep}, options);
    double count = 0;
    for (const glm::dvec2& p : cells.space_points) count += p.x < 0.125 && p.y < 0.125;
    EXPECT_NEAR(count / 6400, inside, 2. / 6400);
  }
  // Empty regions stay empty of space points.
  const auto bars = density_of([](double x, double) { return std::sin(8 * M_PI * x) > 0 ? 1 : 0; }, 64);
  for (const glm::dvec2& p : region_ccvt_cells({Domain::kTorus, bars}, options).space_points)
    ASSERT_GT(std::sin(8 * M_PI * p.x), -1e-6);
}

TEST(LloydRegion, PointsSettleInCentroids) {
  for (const Domain domain : {Domain::kSquare, Domain::kDisk}) {
    LloydOptions options;
    options.n = 9;
    options.rounds = 2000;
    options.region.domain = domain;
    const Points points = lloyd(options);
    const auto cells = bounded_cells(points, domain);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LT(squared(points[i], cells[i].centroid, false), 1e-12);
  }
}

TEST(LloydRegion, DensityOfTwoPointsHasAClosedForm) {
  // Density x on the square, two points: symmetric about y, one above the other or side by side; all the mass
  // in one texel row makes it one-dimensional: density uniform on [0, 1] there, points at 1/4 and 3/4.
  std::vector<double> row(64 * 64, 0);
  for (int x = 0; x < 64; ++x) row[20 * 64 + x] = 1;
  LloydOptions options;
  options.n = 2;
  options.region = {Domain::kSquare, std::make_shared<Density>(64, 64, row)};
  Points points = lloyd(options);
  if (points[0].x > points[1].x) std::swap(points[0], points[1]);
  EXPECT_NEAR(points[0].x, 0.25, 0.01);
  EXPECT_NEAR(points[1].x, 0.75, 0.01);
  EXPECT_NEAR(points[0].y, 20.5 / 64, 0.002);
}

TEST(Generators, RegionsForThoseThatHaveThem) {
  for (const std::string& method : generator_names()) {
    const bool any = method == "random" || method == "jittered" || method == "lloyd" || method == "ccvt";
    for (const std::uint32_t n : {1u, 2u, 30u}) {
      for (const bool dense : {false, true}) {
        for (const Domain domain : {Domain::kTorus, Domain::kSquare, Domain::kDisk}) {
          GeneratorOptions options;
          options.n = n;
          options.capacity = 16;
          options.rounds = 10;
          options.region.domain = domain;
          if (dense)
            options.region.density = density_of([](double x, double y) { return x > 0.5 ? 1 + y : 0; }, 16);
          if (options.region.is_plain_torus()) continue;
          if (!any || (method == "jittered" && dense && domain == Domain::kDisk)) {
            EXPECT_THROW(generate(method, options), InputError) << method;
            continue;
          }
          const Points points = generate(method, options);
          ASSERT_EQ(points.size(), n);
          EXPECT_EQ(points, generate(method, options));
          for (const glm::dvec2& p : points) {
            EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
            EXPECT_TRUE(domain != Domain::kDisk || is_in_disk(p)) << method;
            EXPECT_TRUE(!dense || domain == Domain::kTorus || p.x >= 0.5) << method;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace capcon
