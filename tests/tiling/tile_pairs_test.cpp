#include "tiling/tile_pairs.h"

#include <gtest/gtest.h>

#include "tiling/region_layout.h"
#include "tiling/tied_points.h"

namespace capcon {
namespace {

TileSet a_set(std::uint32_t colours, Colouring colouring) {
  return to_tile_set(random_tied_points(colours, 4, {0, 0, 4}, 1, colouring), "");
}

// Two tiles side by side share two vertices: six free ones, so each of 64 pairs that fit has the chance 1/64,
// times 16 tiles; corner to corner seven; two apart all eight.
TEST(TilePairs, OfACompleteSetAreCountedByHand) {
  TilePairs pairs(a_set(2, Colouring::free), 0);
  const auto entries = [&](int dx, int dy) {
    std::pair<int, double> result{0, 0};  // how many, and each of them
    for (const double w : pairs.at(dx, dy))
      if (w > 0) ++result.first, result.second = w;
    return result;
  };
  EXPECT_EQ(entries(0, 0), std::pair(16, 1.0));
  EXPECT_EQ(entries(1, 0), std::pair(64, 0.25));
  EXPECT_EQ(entries(-1, 1), std::pair(128, 0.125));
  EXPECT_EQ(entries(0, 2), std::pair(256, 0.0625));
  EXPECT_GT(pairs.at(1, 0)[3 * 16 + 9], 0);   // 1,1,0,0 and then 1,0,0,1
  EXPECT_EQ(pairs.at(1, 0)[3 * 16 + 10], 0);  // 0,1,0,1 on the right does not fit
}

TEST(TilePairs, OfACompactSetFitAndSumToTheNumberOfTiles) {
  const TileSet set = a_set(3, Colouring::apart);
  const auto numbers = tile_numbers(set);
  TilePairs pairs(set, 0);
  for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, -1}, {1, 1}, {2, 1}}) {
    double sum = 0;
    const auto& weights = pairs.at(dx, dy);
    for (std::size_t t = 0; t < 35; ++t)
      for (std::size_t u = 0; u < 35; ++u) {
        sum += weights[t * 35 + u];
        EXPECT_TRUE(weights[t * 35 + u] == 0 || can_stand(3, numbers[t], numbers[u], dx, dy));
      }
    EXPECT_NEAR(sum, 35, 1e-9);
  }
  TilePairs small(set, 4);  // one tile alone has four equal corners: colour 0 only
  EXPECT_NEAR(small.at(0, 0)[0] - pairs.at(0, 0)[0], 4 * 35, 1e-9);
}

}  // namespace
}  // namespace capcon
