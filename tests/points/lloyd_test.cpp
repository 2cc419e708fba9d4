#include "points/lloyd.h"

#include <gtest/gtest.h>

#include <cmath>

#include "points/measure.h"

namespace capcon {
namespace {

TEST(Lloyd, EnergyFallsToThePublishedValue) {
  double energy = 3;
  for (const std::uint32_t rounds : {0u, 1u, 3u, 10u, 40u, 300u}) {
    const Measures m = measure(lloyd({1024, 1, rounds}));
    EXPECT_LT(m.energy, energy) << rounds;
    energy = m.energy;
  }
  EXPECT_NEAR(energy, 1.0116, 0.003);
}

TEST(Lloyd, EndsInCentroids) {
  const Points points = lloyd({12, 3, 3000});
  for (const VoronoiCell& cell : voronoi_cells(points))
    EXPECT_LT(std::hypot(cell.centroid.x, cell.centroid.y), 1e-6);
}

TEST(Lloyd, OneRoundIsTheCentroids) {
  const Points start = lloyd({50, 3, 0}), moved = lloyd({50, 3, 1});
  const auto cells = voronoi_cells(start);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const glm::dvec2 d = start[i] + cells[i].centroid - moved[i];
    EXPECT_NEAR(d.x, std::round(d.x), 1e-14);
    EXPECT_NEAR(d.y, std::round(d.y), 1e-14);
  }
}

}  // namespace
}  // namespace capcon
