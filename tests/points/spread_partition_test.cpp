#include "points/spread_partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/hash.h"

namespace capcon {
namespace {

Points random_points(std::uint32_t n) {
  Points points;
  for (std::uint32_t i = 0; i < n; ++i)
    points.emplace_back(uniform64(1, 2, 2 * i), uniform64(1, 2, 2 * i + 1));
  return points;
}

TEST(SpreadPartition, SubsetsAreEven) {
  // The last two are beyond what partition has memory for.
  for (const auto& [n, k] :
       {std::pair{10u, 3u}, {10u, 10u}, {10u, 1u}, {64u, 8u}, {9001u, 50u}, {20000u, 1000u}}) {
    const auto labels = spread_partition(random_points(n), {k, 1});
    std::vector<std::uint32_t> sizes(k);
    for (const std::uint32_t l : labels) ++sizes.at(l);
    EXPECT_LE(*std::ranges::max_element(sizes) - *std::ranges::min_element(sizes), 1u) << n << " in " << k;
  }
}

// A checkerboard's colours are sqrt(2) cells apart, rows one cell; the hexagonal lattice's distance of 32
// points is 1.074 times a square one's.
TEST(SpreadPartition, SpacingIsThatOfTheSubsets) {
  Points points;
  std::vector<std::uint32_t> board, rows;
  for (std::uint32_t i = 0; i < 64; ++i) {
    points.emplace_back(i % 8 / 8.0, i / 8 / 8.0);
    board.push_back((i + i / 8) % 2);
    rows.push_back(i / 8 % 2);
  }
  EXPECT_NEAR(subset_spacing(points, board, 2).mean, 0.9306, 1e-4);
  EXPECT_NEAR(subset_spacing(points, rows, 2).worst, 0.9306 / std::sqrt(2.0), 1e-4);
}

TEST(SpreadPartition, TakesTheBestOfManyTries) {
  const Points points = random_points(64);
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const SubsetSpacing one = subset_spacing(points, partition(points, {8, seed}), 8);
    sum += (one.mean + one.worst) / 8;
  }
  const SubsetSpacing best = subset_spacing(points, spread_partition(points, {8, 1}), 8);
  EXPECT_GT(best.mean + best.worst, sum + 0.02);
}

// Points in Morton blocks: far better than labels by chance, whose subsets' spacing is 0.47.
TEST(SpreadPartition, LargeSetsAreSpreadAlongACurve) {
  const Points points = random_points(20000);
  std::vector<std::uint32_t> labels = spread_partition(points, {500, 1});
  EXPECT_GT(subset_spacing(points, labels, 500).mean, 0.54);
}

}  // namespace
}  // namespace capcon
