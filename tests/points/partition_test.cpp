#include "points/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
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

TEST(Partition, DegenerateInputsAreSaid) {
  EXPECT_EQ(partition({{0.5, 0.5}}, {1, 1}), std::vector<std::uint32_t>{0});
  EXPECT_THROW(partition({{0.5, 0.5}}, {2, 1}), InputError);
  EXPECT_THROW(partition({{0.5, 0.5}}, {0, 1}), InputError);
  EXPECT_EQ(partition(Points(6, {0.5, 0.5}), {3, 1}).size(), 6u);  // all in one place
}

}  // namespace
}  // namespace capcon
