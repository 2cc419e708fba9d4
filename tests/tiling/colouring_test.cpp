#include "tiling/colouring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/hash.h"
#include "tiling/region_layout.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

// The number of closed walks of four steps in the graph of colours that may meet: the trace of A^4, A = J - I
// but for a 1 at colour 0. Its eigenvalues are -1 (C - 2 times) and ((C - 1) +- sqrt((C - 1)^2 + 4)) / 2.
double walks(double colours) {
  const double root = std::sqrt((colours - 1) * (colours - 1) + 4);
  return (colours - 2) + std::pow((colours - 1 + root) / 2, 4) + std::pow((colours - 1 - root) / 2, 4);
}

TEST(Colouring, CompactSetsHaveAsManyTilesAsTheGraphHasWalks) {
  EXPECT_EQ(tile_numbers(2, Colouring::apart).size(), 7u);
  EXPECT_EQ(tile_numbers(3, Colouring::apart).size(), 35u);
  for (const std::uint32_t colours : {2u, 3u, 4u, 5u}) {
    EXPECT_NEAR(double(tile_numbers(colours, Colouring::apart).size()), walks(colours), 1e-6);
    EXPECT_EQ(tile_numbers(colours, Colouring::free).size(), tile_count(colours));
  }
}

// All colourings of a torus of 3 x 3 vertices: the tiles of a set are enough exactly for the allowed ones.
TEST(Colouring, EveryAllowedColouringHasItsTiles) {
  const auto numbers = tile_numbers(3, Colouring::apart);
  const std::set<std::uint32_t> there(numbers.begin(), numbers.end());
  const GaussianTiling tiling(3, 0);
  int allowed_count = 0;
  for (std::uint32_t code = 0; code < 19683; ++code) {
    std::vector<std::uint32_t> colours(9);
    std::uint32_t rest = code;
    for (std::uint32_t& c : colours) c = rest % 3, rest /= 3;
    bool allowed = true, tiled = true;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const auto at = [&](int i, int j) { return colours[(i % 3) + 3 * (j % 3)]; };
        const std::uint32_t here = at(x, y);
        if (here != 0 && (here == at(x + 1, y) || here == at(x, y + 1))) allowed = false;
      }
    for (std::uint32_t cell = 0; cell < 9; ++cell)
      tiled = tiled && there.count(tile_of(tiling, colours, 3, cell)) > 0;
    ASSERT_EQ(tiled, allowed) << code;
    allowed_count += allowed;
  }
  EXPECT_GT(allowed_count, 100);
}

TEST(RandomColours, OfCompactSetsAreAllowedOnEveryTorus) {
  for (std::uint32_t a = 1; a <= 6; ++a)
    for (std::uint32_t b = 0; b <= a; ++b) {
      const GaussianTiling tiling(a, b);
      for (const std::uint32_t colours : {1u, 2u, 3u, 5u})
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
          const auto drawn = random_colours(tiling, colours, Colouring::apart, seed);
          ASSERT_EQ(drawn, random_colours(tiling, colours, Colouring::apart, seed));
          for (std::uint32_t v = 0; v < tiling.size(); ++v) {
            const glm::ivec2 at = tiling.cell(v);
            ASSERT_LT(drawn[v], colours);
            for (const std::uint32_t u : {tiling.index(at.x + 1, at.y), tiling.index(at.x, at.y + 1)})
              ASSERT_TRUE(drawn[v] == 0 || drawn[u] != drawn[v]) << a << "," << b << " seed " << seed;
          }
        }
    }
}

// No tile is rare, no tile stands beside itself often, and the colours 1 and 2 are treated alike.
TEST(RandomColours, OfCompactSetsUseAllTiles) {
  const auto shares = tile_shares(3, Colouring::apart);
  double sum = 0, squares = 0;
  const auto numbers = tile_numbers(3, Colouring::apart);
  for (std::uint32_t t = 0; t < shares.size(); ++t) {
    sum += shares[t];
    squares += shares[t] * shares[t];
    if (std::ranges::binary_search(numbers, t))
      EXPECT_GT(shares[t], 0.01) << t;
    else
      EXPECT_EQ(shares[t], 0) << t;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_GT(1 / squares, 30);  // as many equally frequent tiles would repeat as often
  const GaussianTiling tiling(256, 0);
  const auto drawn = random_colours(tiling, 3, Colouring::apart, 7);
  const auto count = [&](std::uint32_t c) { return double(std::ranges::count(drawn, c)); };
  EXPECT_NEAR(count(1) / count(2), 1, 0.02);
  EXPECT_LT(count(0) / tiling.size(), 0.5);
  int twins = 0;
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
    const glm::ivec2 at = tiling.cell(cell);
    twins += tile_of(tiling, drawn, 3, cell) == tile_of(tiling, drawn, 3, tiling.index(at.x + 1, at.y));
  }
  EXPECT_LT(twins, 0.005 * tiling.size());
}

}  // namespace
}  // namespace capcon
