#include "tiling/tile_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "points/spread_partition.h"
#include "tiling/tile_slots.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

TEST(TileLabels, EveryTileHasEachLabelAsOften) {
  for (const char* name : {"c2n16", "c3n16-compact"}) {
    const TileSet set = shipped_tile_set(std::string(name));
    const TileLabels labels = label_parts(set, 4, 1, 100);
    ASSERT_EQ(labels.size(), set.tiles.size());
    for (std::size_t t = 0; t < labels.size(); ++t) {
      ASSERT_EQ(labels[t].size(), set.tiles[t].size());
      for (std::uint32_t l = 0; l < 4 && !labels[t].empty(); ++l)
        EXPECT_EQ(std::ranges::count(labels[t], l), 4) << name << " tile " << t;
    }
    EXPECT_EQ(labels, label_parts(set, 4, 1, 100)) << "not deterministic";
  }
}

// Random labels: 0.47 to 0.5. What the partition makes of one such tiling's 1024 points: 0.732, 0.80, 0.816.
TEST(TileLabels, PartsOfAnyTilingAreSpread) {
  const TileSet set = shipped_tile_set(2, 16);
  const GaussianTiling tiling(8, 0);
  for (const auto& [parts, least] : {std::pair{2u, 0.695}, {4u, 0.74}, {8u, 0.73}}) {
    const TileLabels labels = label_parts(set, parts);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const auto colours = random_colours(tiling, set, seed);
      std::vector<std::uint32_t> of_points;
      for (std::uint32_t cell = 0; cell < tiling.size(); ++cell)
        std::ranges::copy(labels[tile_of(tiling, colours, set.colours, cell)], std::back_inserter(of_points));
      const SubsetSpacing s = subset_spacing(tile_points(set, tiling, colours, 16), of_points, parts);
      EXPECT_GT(s.worst, least) << parts << " parts, tiling " << seed;
    }
  }
}

// The slots' points lie near each other in all tiles: an eighth of a tile, where ranks alone leave them
// anywhere (0.4); and the figure is what it says.
TEST(TileSlots, PointsOfASlotLieNearOnePlace) {
  const TileSet set = shipped_tile_set(2, 16);
  const TileSlots slots = match_slots(set, 16);
  double squares = 0;
  for (std::size_t t = 0; t < set.tiles.size(); ++t) {
    auto ranks = slots.rank[t];
    for (std::uint32_t s = 0; s < 16; ++s) {
      const glm::dvec2 d = to_double(set.tiles[t][ranks[s]].position) - slots.place[s];
      squares += glm::dot(d, d) / (16 * 16);
    }
    std::ranges::sort(ranks);
    for (std::uint32_t s = 0; s < 16; ++s) EXPECT_EQ(ranks[s], s) << "each point has one slot";
  }
  EXPECT_NEAR(slots.deviation, std::sqrt(squares), 1e-9);
  EXPECT_LT(slots.deviation, 0.13);
}

}  // namespace
}  // namespace capcon
