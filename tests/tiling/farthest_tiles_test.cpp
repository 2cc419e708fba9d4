#include "tiling/farthest_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tiling/make_tiles.h"
#include "tiling/region_layout.h"
#include "tiling/tile_quality.h"

namespace capcon {
namespace {

// All 512 ways to colour 3 x 3 vertices: every way in which two tiles can touch is in one of these patches.
TEST(LeastDistance, IsThatOfAllPatchesOfFourTiles) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const TiedPoints points = random_tied_points(2, 9, {1, 0, 5}, seed);
    double least = 9;
    for (int code = 0; code < 512; ++code) {
      const auto colour = [&](int x, int y) { return std::uint32_t(code >> (x + 3 * y) & 1); };
      std::vector<glm::dvec2> all;
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
          const std::uint32_t tile =
              colour(x, y) + 2 * colour(x + 1, y) + 4 * colour(x, y + 1) + 8 * colour(x + 1, y + 1);
          for (const std::uint32_t i : points.tiles[tile])
            all.push_back(points.free[i].position + glm::dvec2(x, y));
        }
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::length(all[i] - all[j]));
    }
    EXPECT_NEAR(least_distance(points), least / std::sqrt(2 / (std::sqrt(3.0) * 9)), 1e-12);
  }
}

TEST(SpreadApart, ReachesUntiledDistancesWhereAllTilesMayBeAlike) {
  FarthestOptions options;
  options.flatness = 0;
  const TiedPoints start = random_tied_points(2, 16, {0, 0, 16}, 1);
  EXPECT_LT(least_distance(start), 0.3);
  EXPECT_GT(least_distance(spread_apart(start, options)), 0.90);  // untiled farthest points: 0.925
}

TEST(SpreadApart, KeepsItsDistanceInFreshTilings) {
  MakeTilesOptions options;
  options.method = TileMethod::fpo;
  options.starts = 1;
  options.rounds = 100;
  options.moves = 20;
  const TileSet set = make_tiles(options);
  EXPECT_EQ(
      set.recipe,
      "capcon tiles make --colours 2 --points 16 --seed 1 --method fpo --starts 1 --rounds 100 --moves 20");
  EXPECT_EQ(find_region_fault(set), std::nullopt);
  const TilingFigures figures = tiling_figures(set, 8, 0, 16, 3, 5);
  EXPECT_GT(figures.delta_min, 0.80);  // ccvt tiles: 0.6; untiled farthest points: 0.925
  EXPECT_GT(figures.delta_mean, 0.89);
}

}  // namespace
}  // namespace capcon
