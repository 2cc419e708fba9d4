#include "points/halton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "points/generators.h"

namespace capcon {
namespace {

TEST(Halton, ScrambledBlocksFillAllStrata) {
  // Any 2^a 3^b successive points have one in each of the 2^a x 3^b boxes, as the plain ones do.
  for (const auto& [columns, rows] : {std::pair(1, 1), {2, 3}, {8, 9}, {16, 3}, {4, 27}, {32, 27}}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      GeneratorOptions options;
      options.n = static_cast<std::uint32_t>(columns * rows);
      options.seed = seed;
      std::set<std::pair<int, int>> seen;
      for (const glm::dvec2& p : generate("halton-scrambled", options)) {
        seen.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
      }
      EXPECT_EQ(seen.size(), options.n);
    }
  }
}

TEST(Halton, EveryValueIsUniform) {
  for (const std::uint32_t base : {2u, 3u}) {
    for (const std::uint64_t index : {0u, 1u, 5u, 77u}) {
      double sum = 0, squares = 0;
      const int count = 20000;
      for (int seed = 0; seed < count; ++seed) {
        const double v = owen_radical_inverse(index, base, seed, 1);
        ASSERT_TRUE(v >= 0 && v < 1);
        sum += v;
        squares += v * v;
      }
      EXPECT_NEAR(sum / count, 0.5, 5 * std::sqrt(1. / 12 / count));
      EXPECT_NEAR(squares / count, 1. / 3, 5 * std::sqrt(4. / 45 / count));
    }
  }
}

TEST(Halton, PermutationsDependOnThePrefixAlone) {
  // Indices 0 and 27 share three digits in base 3, so do their values; the fourth differs, as 0, 27 and 54
  // are permuted.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    std::set<int> fourth;
    for (const std::uint64_t index : {4, 31, 58}) {
      const double v = owen_radical_inverse(index, 3, seed, 0);
      EXPECT_EQ(static_cast<int>(v * 27), static_cast<int>(owen_radical_inverse(4, 3, seed, 0) * 27));
      fourth.insert(static_cast<int>(v * 81));
    }
    EXPECT_EQ(fourth.size(), 3u);
  }
  // All six orders of the last digit occur, alike often, and apart from the prefix.
  std::map<std::pair<int, int>, int> orders;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const auto digit = [&](std::uint64_t index) {
      return static_cast<int>(owen_radical_inverse(index, 3, seed, 0) * 9) % 3;
    };
    ++orders[{digit(0) * 3 + digit(3), digit(1) * 3 + digit(4)}];
  }
  EXPECT_EQ(orders.size(), 36u);
  for (const auto& [order, count] : orders) EXPECT_NEAR(count, 3000 / 36., 5 * std::sqrt(3000 / 36.));
}

}  // namespace
}  // namespace capcon
