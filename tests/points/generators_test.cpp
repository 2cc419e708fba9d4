#include "points/generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "points/sobol.h"

namespace capcon {
namespace {

/// Whether every elementary interval of area 1/n (2^a columns, 2^b rows, a + b = log2 n) holds one point.
bool is_net(const Points& points) {
  const int log_n = std::countr_zero(points.size());
  for (int a = 0; a <= log_n; ++a) {
    std::set<std::pair<long, long>> seen;
    for (const glm::dvec2& p : points) {
      seen.emplace(std::lround(std::floor(std::ldexp(p.x, a))),
                   std::lround(std::floor(std::ldexp(p.y, log_n - a))));
    }
    if (seen.size() != points.size()) return false;
  }
  return true;
}

TEST(Generators, SobolSetsAreNets) {
  for (const char* method : {"sobol", "sobol-xor", "sobol-owen"}) {
    for (const std::uint32_t n : {1u, 2u, 16u, 64u, 1024u, 4096u}) {
      for (const std::uint64_t seed : {1u, 2u, 99u})
        EXPECT_TRUE(is_net(generate(method, {n, seed, 1}))) << method << n;
    }
  }
  EXPECT_FALSE(is_net(generate("random", {64, 1, 1})));
}

TEST(Generators, SobolAgreesWithPublishedValues) {
  // The first points of Sobol' (dimensions 1 and 2, natural order), as in Bratley and Fox 1988 up to Gray
  // order.
  const Points expected{{0, 0},         {0.5, 0.5},     {0.25, 0.75},   {0.75, 0.25},
                        {0.125, 0.625}, {0.625, 0.125}, {0.375, 0.375}, {0.875, 0.875}};
  EXPECT_EQ(generate("sobol", {8, 1, 1}), expected);
}

TEST(Generators, HaltonAgreesWithRadicalInverses) {
  const Points points = generate("halton", {8, 1, 1});
  const double twos[] = {0, 1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8};
  const double threes[] = {0, 1. / 3, 2. / 3, 1. / 9, 4. / 9, 7. / 9, 2. / 9, 5. / 9};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_DOUBLE_EQ(points[i].x, twos[i]);
    EXPECT_DOUBLE_EQ(points[i].y, threes[i]);
  }
  EXPECT_DOUBLE_EQ(radical_inverse(1234567, 10), 0.7654321);
}

TEST(Generators, OwenScramblingIsNestedAndUniform) {
  // Two fractions that share exactly their first k bits still do; the bit after that differs.
  for (int k = 0; k < 32; ++k) {
    const std::uint32_t a = 0x9e3779b9u, b = a ^ (1u << (31 - k)) ^ ((1u << (31 - k)) - 1) / 3;
    EXPECT_EQ(std::countl_zero(owen_scrambled(a, 4, 1) ^ owen_scrambled(b, 4, 1)), std::countl_zero(a ^ b));
  }
  // Over seeds, bit 2 of the result is a fair coin for each of the four prefixes, and these are independent.
  std::map<std::uint32_t, int> patterns;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    std::uint32_t pattern = 0;
    for (std::uint32_t prefix = 0; prefix < 4; ++prefix) {
      pattern = pattern << 1 | (owen_scrambled(prefix << 30, seed, 0) >> 29 & 1);
    }
    ++patterns[pattern];
  }
  ASSERT_EQ(patterns.size(), 16u);
  for (const auto& [pattern, count] : patterns) EXPECT_NEAR(count, 250, 5 * std::sqrt(250)) << pattern;
}

TEST(Generators, XorIsOneDigitShiftASet) {
  const Points plain = generate("sobol", {64, 1, 1}), moved = generate("sobol-xor", {64, 1, 1});
  std::set<std::pair<std::uint32_t, std::uint32_t>> flips;
  for (std::size_t i = 0; i < 64; ++i) {
    const auto bits = [](double v) { return static_cast<std::uint32_t>(v * 0x1p32); };
    flips.emplace(bits(plain[i].x) ^ bits(moved[i].x), bits(plain[i].y) ^ bits(moved[i].y));
  }
  EXPECT_EQ(flips.size(), 1u);
}

TEST(Generators, JitteredHasOnePointAStratum) {
  for (const auto& [n, columns, rows] :
       {std::tuple(1, 1, 1), {16, 4, 4}, {1024, 32, 32}, {12, 4, 3}, {56, 8, 7}}) {
    std::set<std::pair<int, int>> seen;
    for (const glm::dvec2& p : generate("jittered", {static_cast<std::uint32_t>(n), 5, 1})) {
      seen.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(n)) << n;
  }
  // 7: rows of 2, 2 and 3 strata, heights in proportion.
  const Points seven = generate("jittered", {7, 5, 1});
  std::map<int, int> in_row;
  for (const glm::dvec2& p : seven) ++in_row[p.y < 2. / 7 ? 0 : p.y < 4. / 7 ? 1 : 2];
  EXPECT_THAT(in_row, testing::ElementsAre(testing::Pair(0, 2), testing::Pair(1, 2), testing::Pair(2, 3)));
}

TEST(Generators, AnyCountInRangeAndBySeed) {
  for (const std::string& method : generator_names()) {
    const bool seeded = method != "sobol" && method != "halton" && method != "lattice";
    for (const std::uint32_t n : {1u, 2u, 3u, 7u, 97u, 200u}) {
      const Points points = generate(method, {n, 11, 16});
      EXPECT_EQ(points.size(), n);
      for (const glm::dvec2& p : points) EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << method;
      EXPECT_EQ(points, generate(method, {n, 11, 16})) << method;
      EXPECT_EQ(points != generate(method, {n, 12, 16}), seeded) << method;
    }
  }
}

TEST(Generators, SaysWhichMethodsThereAre) {
  EXPECT_THAT([] { generate("poisson", {}); }, testing::ThrowsMessage<InputError>(testing::AllOf(
                                                   testing::HasSubstr("no method \"poisson\""),
                                                   testing::HasSubstr("sobol-owen, halton, "))));
  EXPECT_THROW(generate("random", {0, 1, 1}), InputError);
}

}  // namespace
}  // namespace capcon
