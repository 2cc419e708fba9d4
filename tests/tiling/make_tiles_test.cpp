#include "tiling/make_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "base/hash.h"
#include "tiling/mean_tile.h"
#include "tiling/region_layout.h"
#include "tiling/tied_optimiser.h"
#include "tiling/tile_quality.h"
#include "tiling/tile_ranking.h"

namespace capcon {
namespace {

MakeTilesOptions tiny() {
  MakeTilesOptions options;
  options.starts = 2;
  options.rounds = 6;
  options.tilings = 3;
  options.moves = 200;
  return options;
}

TEST(MakeTiles, SameBitsAgainAndForAnyNumberOfThreads) {
  ::setenv("CAPCON_THREADS", "1", 1);
  const std::string once = format_tile_set(make_tiles(tiny()));
  EXPECT_EQ(once, format_tile_set(make_tiles(tiny())));
  ::setenv("CAPCON_THREADS", "3", 1);
  EXPECT_EQ(once, format_tile_set(make_tiles(tiny())));
  ::unsetenv("CAPCON_THREADS");
  MakeTilesOptions other = tiny();
  other.seed = 2;
  EXPECT_NE(once, format_tile_set(make_tiles(other)));
}

TEST(MakeTiles, OtherShapesAreWholeSets) {
  MakeTilesOptions options = tiny();
  options.shared_corner = 1;
  options.shared_edge = 2;
  const TileSet set = make_tiles(options);
  EXPECT_EQ(find_region_fault(set), std::nullopt);
  EXPECT_EQ(set.recipe,
            "capcon tiles make --colours 2 --points 16 --seed 1 --shared-corner 1 --shared-edge 2 "
            "--starts 2 --rounds 6 --tilings 3 --moves 200");
  for (const auto& tile : set.tiles) EXPECT_EQ(tile.size(), 16u);
  options = tiny();
  options.colours = 3;
  options.points_per_tile = 9;
  EXPECT_EQ(make_tiles(options).tile_count(), 81u);
  options.colouring = Colouring::apart;
  const TileSet compact = make_tiles(options);
  EXPECT_EQ(compact.tile_count(), 35u);
  EXPECT_EQ(find_region_fault(compact), std::nullopt);
  options.points_per_tile = 1000;
  EXPECT_THROW(make_tiles(options), InputError);
  options = tiny();
  options.shared_corner = 5;
  EXPECT_THROW(make_tiles(options), InputError);
}

TEST(TiedOptimiser, EnergyFallsRoundByRound) {
  const GaussianTiling tiling(4, 0);
  std::vector<TrainingTiling> training;
  for (std::uint64_t seed : {1, 2}) training.push_back({tiling, random_colours(tiling, 2, seed), 1});
  for (const double flatness : {0.0, 0.001}) {
    TiedOptimiser optimiser(random_tied_points(2, 16, {1, 1, 8}, 1), training, flatness);
    optimiser.round(1e-7);
    double last = optimiser.round(1e-7);
    for (int k = 0; k < 10; ++k) {
      const double next = optimiser.round(1e-7);
      EXPECT_LT(next, last * (1 + 1e-9));
      last = next;
    }
  }
}

TEST(EqualCells, AreEqualAndTileTheTorus) {
  const TiedPoints points = random_tied_points(2, 16, {0, 0, 16}, 5);
  for (const auto& [a, b] : {std::pair{1, 0}, {1, 1}, {3, 1}, {4, 0}}) {
    const GaussianTiling tiling(a, b);
    EqualCells cells(tiling, random_colours(tiling, 2, 9), points);
    cells.solve(points, 1e-9);
    double sum = 0, worst = 0;
    for (const PowerCell& cell : cells.cells()) {
      sum += cell.area;
      worst = std::max(worst, std::abs(cell.area * 16 - 1));
    }
    EXPECT_NEAR(sum, tiling.size(), 1e-9 * tiling.size());
    EXPECT_LE(worst, 1e-9);
  }
}

TEST(MeanTile, GradientIsTheDifferenceQuotient) {
  TiedPoints points = random_tied_points(2, 16, {1, 1, 8}, 2);
  std::vector<glm::dvec2> gradient;
  constexpr double kStep = 1e-6;
  for (const bool low_first : {false, true}) {
    const auto value = [&] { return mean_tile_unevenness(points, 8, nullptr, low_first); };
    mean_tile_unevenness(points, 8, &gradient, low_first);
    for (const std::size_t i : {0u, 9u, 50u}) {
      auto& y = points.free[i].position.y;
      const double at = y;
      y = at + kStep;
      const double above = value();
      y = at - kStep;
      const double below = value();
      y = at;
      EXPECT_NEAR(gradient[i].y, (above - below) / (2 * kStep), 1e-4 * (1 + std::abs(gradient[i].y)));
    }
  }
}

TEST(RankPoints, KeepsThePointsAndSpreadsPrefixes) {
  const TileSet shipped = shipped_tile_set();
  TileSet shuffled = shipped;
  for (std::size_t t = 0; t < shuffled.tiles.size(); ++t)
    for (std::size_t k = 15; k > 0; --k)
      std::swap(shuffled.tiles[t][k], shuffled.tiles[t][mix64(7, t, k) % (k + 1)]);
  TileSet ranked = shuffled;
  rank_points(ranked, 1, 2000);
  for (std::size_t t = 0; t < ranked.tiles.size(); ++t) {
    std::vector<bool> seen(16);
    for (const auto& p : ranked.tiles[t]) seen[p.slot] = true;
    EXPECT_EQ(seen, std::vector<bool>(16, true));
  }
  for (const std::uint32_t r : {1u, 2u, 4u, 8u}) {
    const TilingFigures random = tiling_figures(shuffled, 8, 0, r, 3, 5),
                        good = tiling_figures(ranked, 8, 0, r, 3, 5);
    EXPECT_LT(good.energy, random.energy - 0.1) << r;
    EXPECT_GT(good.delta_mean, random.delta_mean + 0.02) << r;
  }
}

}  // namespace
}  // namespace capcon
