#include "render/sample_order.h"

#include <gtest/gtest.h>

#include <set>

namespace capcon {
namespace {

// Eight neighbours of 64 scrambled points share a cell of 2 x 4 (of 4 x 2 are as good, but this is what
// Morton order cuts), in pixels that the order was not made from. In index order they are spread over
// everything.
TEST(SampleOrder, NeighboursShareACellInEveryPixel) {
  for (const char* name : {"sobol-xor", "sobol-owen", "jittered"}) {
    const auto sampler = make_sampler(name, 64, 5);
    const auto order = sample_order(*sampler);
    ASSERT_EQ(order.size(), 64u) << name;
    std::set<std::uint32_t> seen;
    for (const glm::uvec4 texel : order) seen.insert(texel.x);
    EXPECT_EQ(seen.size(), 64u) << name;
    EXPECT_EQ(*seen.rbegin(), 63u) << name;
    for (const std::uint32_t pixel : {1u, 77u, 123456u}) {
      for (std::uint32_t group = 0; group < 8; ++group) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
        for (std::uint32_t lane = 0; lane < 8; ++lane) {
          const FixedPoint p = sampler->sample(pixel, order[8 * group + lane].x, 0, SampleDomain::disk);
          cells.emplace(p.x >> 31, p.y >> 30);
        }
        EXPECT_EQ(cells.size(), 1u) << name << " pixel " << pixel << " group " << group;
      }
    }
  }
}

// Its pixels choose among sequences, which have square cells in common: four neighbours of 64 share one
// of 16.
TEST(SampleOrder, NeighboursShareACellInEverySequenceOfPmj02) {
  const auto sampler = make_sampler("pmj02", 64, 5);
  const auto order = sample_order(*sampler);
  ASSERT_EQ(order.size(), 64u);
  for (std::uint32_t pixel = 0; pixel < 100; ++pixel) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> all;
    for (std::uint32_t group = 0; group < 16; ++group) {
      std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        const FixedPoint p = sampler->sample(pixel, order[4 * group + lane].x, 0, SampleDomain::disk);
        cells.emplace(p.x >> 30, p.y >> 30);
      }
      EXPECT_EQ(cells.size(), 1u) << pixel << " group " << group;
      all.merge(cells);
    }
    EXPECT_EQ(all.size(), 16u);
  }
}

TEST(SampleOrder, NoneWhereThereIsNoneToGain) {
  EXPECT_TRUE(sample_order(*make_sampler("random", 64, 1)).empty());
  EXPECT_TRUE(sample_order(*make_sampler("capcon", 64, 1)).empty());
  EXPECT_TRUE(sample_order(*make_sampler("sobol-owen", 8, 1)).empty());
}

}  // namespace
}  // namespace capcon
