// Tiles with a border: the set, its tilings of the bounded square, and the cells that make them unbiased.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "points/measure_bounded.h"
#include "tiling/even_cells.h"
#include "tiling/even_points.h"
#include "tiling/make_tiles.h"
#include "tiling/region_layout.h"
#include "tiling/tied_optimiser.h"
#include "tiling/tile_quality.h"
#include "tiling/training_tilings.h"

namespace capcon {
namespace {

MakeTilesOptions tiny() {
  MakeTilesOptions options;
  options.colouring = Colouring::bounded;
  options.starts = 1;
  options.rounds = 4;
  options.tilings = 3;
  options.moves = 20;
  return options;
}

// C^4 inner, 4 C^2 side and 4 C corner tiles.
TEST(BoundedTiles, AreCompleteForEveryNumberOfColours) {
  for (const std::uint32_t inside : {1u, 2u, 3u}) {
    std::map<int, std::uint32_t> classes;
    for (const std::uint32_t t : tile_numbers(inside + 1, Colouring::bounded))
      ++classes[outside_sides(tile_colours(inside + 1, t), inside).count()];
    EXPECT_EQ(classes[0], inside * inside * inside * inside);
    EXPECT_EQ(classes[1], 4 * inside * inside);
    EXPECT_EQ(classes[2], 4 * inside);
    EXPECT_EQ(classes.size(), 3u);
  }
}

// Every colouring asks for tiles that there are, whose sides outside are the square's.
TEST(BoundedTiles, EveryCellOfATilingHasATile) {
  const auto numbers = tile_numbers(3, Colouring::bounded);
  for (const std::uint32_t side : {2u, 3u, 7u}) {
    const GaussianTiling tiling(side, 0);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const auto colours = random_colours(tiling, 3, Colouring::bounded, seed);
      for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
        const std::uint32_t tile = tile_of(tiling, colours, 3, cell);
        ASSERT_TRUE(std::ranges::binary_search(numbers, tile));
        const OutsideSides sides = outside_sides(tile_colours(3, tile), 2);
        const glm::ivec2 at = tiling.cell(cell);
        EXPECT_EQ(sides.left, at.x == 0);
        EXPECT_EQ(sides.right, at.x + 1 == int(side));
        EXPECT_EQ(sides.bottom, at.y == 0);
        EXPECT_EQ(sides.top, at.y + 1 == int(side));
      }
    }
  }
  EXPECT_THROW(random_colours(GaussianTiling(1, 0), 3, Colouring::bounded, 1), InputError);
  EXPECT_THROW(random_colours(GaussianTiling(2, 2), 3, Colouring::bounded, 1), InputError);
}

TEST(BoundedTiles, EqualCellsTileTheSquareAndEndAtItsSides) {
  const TiedPoints points = random_tied_points(3, 16, {0, 0, 16}, 5, Colouring::bounded);
  for (const std::uint32_t side : {2u, 3u, 5u}) {
    const GaussianTiling tiling(side, 0);
    EqualCells cells(tiling, random_colours(tiling, 3, Colouring::bounded, 9), points);
    cells.solve(points, 1e-9);
    glm::dvec2 centre(0);
    double worst = 0;
    for (std::size_t site = 0; site < cells.site_count(); ++site) {
      const PowerCell& cell = cells.cells()[site];
      worst = std::max(worst, std::abs(cell.area * 16 - 1));
      centre += cell.area * (glm::dvec2(tiling.cell(std::uint32_t(site / 16))) +
                             points.free[cells.free_point(site)].position + cell.centroid);
    }
    EXPECT_LE(worst, 1e-9);
    // Cells that wrapped round would not have the square's own centroid.
    EXPECT_NEAR(centre.x, 0.5 * side * side * side, 1e-7);
    EXPECT_NEAR(centre.y, 0.5 * side * side * side, 1e-7);
  }
}

// The cells of all points of a class, in all orientations, cover a tile evenly: what unbiasedness needs.
// Counted on a grid of 64 x 64.
TEST(EvenCells, OfEveryClassCoverATileEvenly) {
  const TileSet set = shipped_tile_set("c2n16-bounded");
  ASSERT_EQ(find_shared_cell(set), std::nullopt);
  constexpr int kGrid = 64;
  const EvenCells cells(set.colours, set.points_per_tile);
  std::array<std::vector<double>, 3> cover;
  for (auto& c : cover) c.resize(kGrid * kGrid);
  for (std::uint32_t t = 0; t < set.tiles.size(); ++t)
    for (const TileSet::TilePoint& point : set.tiles[t]) {
      const EvenCells::Cell cell = cells.cell(t, to_double(point.position));
      const OutsideSides sides = outside_sides(tile_colours(3, t), 2);
      const int x0 = int(cell.low.x * kGrid), nx = int(cell.size.x * kGrid), ny = int(cell.size.y * kGrid);
      for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j) {
          const int up = cell.twin != 0 && 2 * i >= nx ? cell.twin * ny : 0;
          glm::ivec2 at(x0 + i, int(cell.low.y * kGrid) + up + j);
          // The square's symmetries that bring the tile's sides outside to the left and below.
          if (sides.right) at.x = kGrid - 1 - at.x;
          if (sides.top) at.y = kGrid - 1 - at.y;
          const int c = sides.count();
          if (c == 1 && (sides.left || sides.right)) std::swap(at.x, at.y);
          for (int k = 0; k < 8; ++k) {
            glm::ivec2 q = at;
            if (c == 2 && (k & 3) != 0) continue;
            if (c == 1 && (k & 6) != 0) continue;
            if (k & 1) q.x = kGrid - 1 - q.x;
            if (k & 2) q.y = kGrid - 1 - q.y;
            if (k & 4) std::swap(q.x, q.y);
            ASSERT_TRUE(q.x >= 0 && q.y >= 0 && q.x < kGrid && q.y < kGrid);
            cover[c][q.y * kGrid + q.x] += 1.0 / (nx * ny);
          }
        }
    }
  for (const auto& class_cover : cover) {
    const auto [least, most] = std::ranges::minmax(class_cover);
    EXPECT_NEAR(least, most, 1e-9);
    EXPECT_GT(least, 0);
  }
}

TEST(EvenCells, MakeEvenGivesEveryPointACellWhateverTheNumbers) {
  for (const auto& [colours, n] : {std::pair{3u, 16u}, {3u, 9u}, {2u, 5u}, {4u, 7u}, {2u, 8u}}) {
    TiedPoints points = random_tied_points(colours, n, {0, 0, n}, 3, Colouring::bounded);
    for (const double settled : {0.0, 1.0}) {
      make_even(points, settled);
      EXPECT_EQ(find_shared_cell(to_tile_set(points, "a test")), std::nullopt) << colours << " " << n;
    }
  }
}

TEST(MakeBoundedTiles, SameBitsForAnyNumberOfThreadsAndEven) {
  ::setenv("CAPCON_THREADS", "1", 1);
  const TileSet set = make_tiles(tiny());
  const std::string once = format_tile_set(set);
  ::setenv("CAPCON_THREADS", "3", 1);
  EXPECT_EQ(once, format_tile_set(make_tiles(tiny())));
  ::unsetenv("CAPCON_THREADS");
  EXPECT_EQ(set.tile_count(), 40u);
  EXPECT_EQ(find_shared_cell(set), std::nullopt);
  EXPECT_EQ(find_region_fault(set), std::nullopt);
  EXPECT_EQ(set.recipe,
            "capcon tiles make --colours 2 --points 16 --seed 1 --boundary --starts 1 --rounds 4 --tilings 3 "
            "--moves 20");
  const TileSet back = parse_tile_set(once, "my.tiles");
  EXPECT_EQ(format_tile_set(back), once);
  EXPECT_TRUE(back.bounded());
  MakeTilesOptions wrong = tiny();
  wrong.shared_edge = 1;
  EXPECT_THROW(make_tiles(wrong), InputError);
}

std::string message(const std::string& text) {
  try {
    parse_tile_set(text, "my.tiles");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Version 3 as it was written first.
TEST(BoundedTiles, FrozenBytesOfVersionThree) {
  const std::string text = read_file(CAPCON_SOURCE_DIR "/tests/fuzz/corpus/tiles/bounded.tiles");
  const TileSet set = parse_tile_set(text, "my.tiles");
  EXPECT_EQ(checksum(set), 0xa0fbaee7f47a1938u);
  EXPECT_EQ(set.tile_count(), 9u);
  EXPECT_EQ(set.tiles[5][0].position, (FixedPoint{3738418189u, 4043477624u}));
  EXPECT_EQ(format_tile_set(set), text);
}

TEST(BoundedTiles, WrongFilesAreOneClearSentence) {
  using ::testing::StartsWith;
  const std::string text = read_file(shipped_file("tiles/c2n16-bounded.tiles"));
  const auto edited = [&](const std::string& from, const std::string& to) {
    std::string result = text;
    return result.replace(result.find(from), from.size(), to);
  };
  EXPECT_EQ(message(text), "");
  EXPECT_THAT(message(edited("bounded", "apart")), StartsWith("my.tiles:4: 'colouring bounded' should"));
  EXPECT_THAT(message(edited("colours 3", "colours 1")), StartsWith("my.tiles:2: a bounded set has 2"));
  EXPECT_THAT(message(edited("capcon-tiles 3", "capcon-tiles 4")), StartsWith("my.tiles:1: version '4'"));
  EXPECT_THAT(message(edited("tile 1\n", "tile 2\n")),
              StartsWith("my.tiles:23: 'tile 1' should stand here: a bounded set has 40 tiles"));
  EXPECT_THAT(message(edited(" interior 0 3\n", " interior 0 4\n")), StartsWith("my.tiles:"));
}

// Beside capacity-constrained points made in the square, capacity 1024: energy 1.0523, 1.0434 and 1.0384 for
// 64, 256 and 1024 points.
TEST(ShippedBoundedTiles, TilingsAreNearlyAsGoodAsUntiledPointsOfTheSquare) {
  const TileSet set = shipped_tile_set("c2n16-bounded");
  EXPECT_EQ(set.tile_count(), 40u);
  struct Case {
    std::uint32_t side;
    double untiled;
  };
  for (const Case c : {Case{2, 1.0523}, Case{4, 1.0434}, Case{8, 1.0384}}) {
    const TilingFigures f = tiling_figures(set, c.side, 0, 16, 6, 99);
    EXPECT_LT(f.energy, 1.035 * c.untiled) << c.side;
    EXPECT_GT(f.delta_min, 0.45) << c.side;
    for (std::uint32_t i = 0; i < 6; ++i)
      for (const glm::dvec2 p : fresh_tiling(set, GaussianTiling(c.side, 0), 16, i, 99)) {
        EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < 1 && p.y < 1);
      }
  }
}

TEST(MeasureBounded, OfASquareGridHasItsClosedForms) {
  Points grid;
  for (int i = 0; i < 36; ++i) grid.emplace_back((i % 6 + 0.5) / 6, (i / 6 + 0.5) / 6);
  const Measures m = measure_bounded(grid);
  EXPECT_NEAR(m.energy, 1 / 6.0 / kHexagonEnergy, 1e-9);
  EXPECT_NEAR(m.delta_min, 1 / 6.0 / std::sqrt(2 / (std::sqrt(3.0) * 36)), 1e-9);
  EXPECT_NEAR(m.area_sd, 0, 1e-9);
  EXPECT_EQ(m.n, 36u);
  // Two points at opposite sides: far apart, which on the torus they are not.
  EXPECT_NEAR(measure_bounded({{0.01, 0.5}, {0.99, 0.5}}).delta_min, 0.98 / std::sqrt(1 / std::sqrt(3.0)),
              1e-9);
}

}  // namespace
}  // namespace capcon
