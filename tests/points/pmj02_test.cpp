#include "points/pmj02.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>

#include "points/sobol.h"

namespace capcon {
namespace {

std::uint32_t top(std::uint32_t word, std::uint32_t bits) {
  return bits == 0 ? 0 : word >> (32 - bits);
}

/// One point in each elementary interval of area 1/n, n = 2^m points.
bool is_net(std::span<const glm::uvec2> points) {
  std::uint32_t m = 0;
  while (1u << m < points.size()) ++m;
  for (std::uint32_t j = 0; j <= m; ++j) {
    std::vector<bool> taken(points.size());
    for (const glm::uvec2 p : points) {
      const std::uint32_t cell = top(p.x, j) << (m - j) | top(p.y, m - j);
      if (taken[cell]) return false;
      taken[cell] = true;
    }
  }
  return true;
}

TEST(Pmj02, EveryPrefixAndBlockOfAPowerOfTwoIsANet) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    const auto points = pmj02_sequence(4096, seed);
    for (std::uint32_t size = 2; size <= 4096; size *= 2) {
      for (std::uint32_t first = 0; first < 4096; first += size)
        ASSERT_TRUE(is_net(std::span(points).subspan(first, size))) << seed << " " << size << " " << first;
    }
  }
}

// What the paper calls progressive multi-jittered: 4^k points have one in each cell of a grid and in each of
// 4^k rows and columns; and the next 4^k go to the sub-quadrants across from those, quadrant by quadrant.
TEST(Pmj02, IsProgressiveMultiJittered) {
  const auto points = pmj02_sequence(2 * 1024, 9);
  for (std::uint32_t k = 0; k <= 5; ++k) {
    const std::uint32_t n = 1u << (2 * k);
    std::set<std::uint32_t> cells, columns, rows;
    for (std::uint32_t i = 0; i < n; ++i) {
      cells.insert(top(points[i].x, k) << k | top(points[i].y, k));
      columns.insert(top(points[i].x, 2 * k));
      rows.insert(top(points[i].y, 2 * k));
      for (int axis = 0; axis < 2; ++axis)
        EXPECT_EQ(top(points[i][axis], k + 1) ^ 1u, top(points[n + i][axis], k + 1)) << i;
    }
    EXPECT_EQ(cells.size(), n);
    EXPECT_EQ(columns.size(), n);
    EXPECT_EQ(rows.size(), n);
  }
}

TEST(Pmj02, PrefixesAreThoseOfLongerOnesAndSeedsDiffer) {
  const auto longer = pmj02_sequence(1000, 4);
  EXPECT_EQ(longer.size(), 1000u);
  for (const std::uint32_t n : {1u, 2u, 3u, 17u, 512u})
    EXPECT_TRUE(std::ranges::equal(pmj02_sequence(n, 4), std::span(longer).first(n))) << n;
  EXPECT_NE(pmj02_sequence(1, 4), pmj02_sequence(1, 5));
}

// Which axis comes first is drawn: points 2 and 0 share a column in about half of all sequences, else a row.
// And the place in a stratum is: the digits that no net prescribes are even.
TEST(Pmj02, ChoicesAreDrawn) {
  int columns = 0, upper = 0;
  constexpr int kSequences = 1000;
  for (int seed = 0; seed < kSequences; ++seed) {
    const auto points = pmj02_sequence(4, static_cast<std::uint64_t>(seed));
    const bool column = top(points[0].x, 1) == top(points[2].x, 1),
               row = top(points[0].y, 1) == top(points[2].y, 1);
    EXPECT_NE(column, row);
    columns += column ? 1 : 0;
    upper += static_cast<int>(points[3].y >> 29 & 1);
  }
  EXPECT_NEAR(columns, kSequences / 2, 80);  // five standard deviations
  EXPECT_NEAR(upper, kSequences / 2, 80);
}

using Ranks = std::array<std::uint32_t, 16>;  ///< of the y of the point whose x has a rank

template <class Points>
Ranks ranks_of(const Points& points) {
  Ranks ranks{};
  for (const auto& p : points) ranks[p.x >> 28] = p.y >> 28;
  return ranks;
}

/// Is there an Owen scrambling of x and one of y, of four digits, that takes one set to the other? All 2^15
/// of x are tried; that of y follows, and is one if digits depend on digits before them alone.
bool owen_scrambled_alike(const Ranks& from, const Ranks& to) {
  for (std::uint32_t flips = 0; flips < 1u << 15; ++flips) {
    Ranks map{};  // of y
    for (std::uint32_t x = 0; x < 16; ++x) {
      std::uint32_t moved = x;
      for (std::uint32_t j = 0; j < 4; ++j)  // node 2^j + (the j digits before), one bit of `flips` each
        moved ^= (flips >> ((1u << j) - 1 + (x >> (4 - j))) & 1) << (3 - j);
      map[from[x]] = to[moved];
    }
    bool tree = true;
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t j = 0; j < 4; ++j) {
        const std::uint32_t mate = y ^ (1u << j);  // differs in digit 4 - j first
        tree &= (map[y] ^ map[mate]) >> j == 1;
      }
    }
    if (tree) return true;
  }
  return false;
}

// As sets, 16 points are an Owen-scrambled Sobol' set; not every (0,4,2)-net is: 2^32 nets of four digits
// (Ahmed and Wonka, "Optimizing Dyadic Nets", 2021) are more than the 2^30 pairs of scramblings.
TEST(Pmj02, SixteenPointsAreAnOwenScrambledSobolSet) {
  std::array<glm::uvec2, 16> sobol;
  for (std::uint32_t i = 0; i < 16; ++i) sobol[i] = {sobol_x(i), sobol_y(i)};
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_TRUE(owen_scrambled_alike(ranks_of(sobol), ranks_of(pmj02_sequence(16, seed)))) << seed;
  // What the test can tell: a net that was drawn column by column is no such set.
  const Ranks other = {15, 0, 11, 4, 8, 7, 3, 12, 6, 9, 2, 13, 14, 5, 10, 1};
  std::vector<glm::uvec2> drawn;
  for (std::uint32_t x = 0; x < 16; ++x) drawn.emplace_back(x << 28, other[x] << 28);
  EXPECT_TRUE(is_net(drawn));
  EXPECT_FALSE(owen_scrambled_alike(ranks_of(sobol), other));
}

}  // namespace
}  // namespace capcon
