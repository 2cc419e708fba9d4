#include "points/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/hash.h"
#include "points/ccvt.h"
#include "points/measure.h"

namespace capcon {
namespace {

// The text's example, 1024 capacity-constrained points in 8 subsets of 128: 0.807 to 0.817, mean 0.810.
TEST(Partition, ReachesTheTextsSpacingOn8Times128) {
  CcvtOptions options;
  options.capacity = 256;
  const Points points = ccvt(options).points;
  const auto labels = partition(points, {8, 1});
  double sum = 0, worst = 1;
  for (const Points& subset : split(points, labels, 8)) {
    EXPECT_EQ(subset.size(), 128u);
    const double spacing = measure(subset).delta_mean;
    sum += spacing / 8;
    worst = std::min(worst, spacing);
  }
  EXPECT_GE(sum, 0.80);
  EXPECT_GE(worst, 0.79);
}

TEST(Partition, KeepsEveryPointAndEvenSizes) {
  Points points;
  for (int i = 0; i < 50; ++i) points.emplace_back(i * 0.02, (i * 7 % 50) * 0.02);
  for (std::uint32_t subsets : {1u, 2u, 3u, 7u, 49u, 50u}) {
    const auto labels = partition(points, {subsets, 3});
    std::map<std::uint32_t, int> sizes;
    for (const auto label : labels) ++sizes[label];
    ASSERT_EQ(sizes.size(), subsets);
    for (const auto& [label, size] : sizes) {
      EXPECT_GE(size, static_cast<int>(50 / subsets));
      EXPECT_LE(size, static_cast<int>(50 / subsets) + 1);
    }
    EXPECT_EQ(labels, partition(points, {subsets, 3})) << "not deterministic";
  }
  EXPECT_NE(partition(points, {5, 3}), partition(points, {5, 4}));
}

// Two interleaved lattices: the partition that keeps neighbours apart is the checkerboard, whose spacing is
// sqrt(2) cells.
TEST(Partition, FindsNearlyACheckerboard) {
  Points points;
  for (int i = 0; i < 64; ++i) points.emplace_back((i % 8) / 8.0, (i / 8) / 8.0);
  double best = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto sets = split(points, partition(points, {2, seed}), 2);
    best = std::max(best, std::min(measure(sets[0]).delta_mean, measure(sets[1]).delta_mean));
  }
  const double random = 0.70;  // neighbours in the same subset nearly everywhere: spacing of one cell
  EXPECT_GT(best, random);
}

// The rule itself, with every distance computed anew: 60 points in 8 subsets, so that all distances are
// listed.
TEST(Partition, IsTheNaiveRule) {
  constexpr std::uint32_t kPoints = 60, kSubsets = 8;
  Points points;
  for (std::uint64_t i = 0; i < kPoints; ++i)
    points.emplace_back(uniform64(3, 1, 2 * i), uniform64(3, 1, 2 * i + 1));
  std::vector<std::uint32_t> order(kPoints), labels(kPoints);
  for (std::uint32_t i = 0; i < kPoints; ++i) order[i] = i;
  std::ranges::sort(order, {}, [](std::uint32_t i) { return mix64(9, 0, i); });
  for (std::uint32_t i = 0; i < kPoints; ++i) labels[order[i]] = i % kSubsets;
  const auto nearest = [&](std::uint32_t i, std::uint32_t label, std::uint32_t without) {
    double least = 9;
    for (std::uint32_t j = 0; j < kPoints; ++j) {
      if (j == i || j == without || labels[j] != label) continue;
      const glm::dvec2 d = points[i] - points[j];
      least = std::min(least, std::hypot(std::remainder(d.x, 1.0), std::remainder(d.y, 1.0)));
    }
    return least;
  };
  for (bool traded = true; traded;) {
    traded = false;
    for (std::uint32_t x = 0; x < kPoints; ++x) {
      double best_gain = 1e-12;
      std::uint32_t best = x;
      for (std::uint32_t y = 0; y < kPoints; ++y) {
        const std::uint32_t a = labels[x], b = labels[y];
        if (a == b) continue;
        const double gain = nearest(y, a, x) + nearest(x, b, y) - nearest(x, a, x) - nearest(y, b, y);
        if (gain > best_gain) best_gain = gain, best = y;
      }
      if (best != x) std::swap(labels[x], labels[best]), traded = true;
    }
  }
  EXPECT_EQ(partition(points, {kSubsets, 9}), labels);
}

TEST(Partition, DegenerateInputsAreSaid) {
  EXPECT_EQ(partition({{0.5, 0.5}}, {1, 1}), std::vector<std::uint32_t>{0});
  EXPECT_THROW(partition({{0.5, 0.5}}, {2, 1}), InputError);
  EXPECT_THROW(partition({{0.5, 0.5}}, {0, 1}), InputError);
  EXPECT_EQ(partition(Points(6, {0.5, 0.5}), {3, 1}).size(), 6u);  // all in one place
}

}  // namespace
}  // namespace capcon
