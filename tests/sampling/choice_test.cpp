#include "sampling/choice.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "base/hash.h"

namespace capcon {
namespace {

TEST(Choice, PermutesAnyCount) {
  for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u, 16u, 17u, 100u, 400u, 1024u, 5000u}) {
    std::set<std::uint32_t> places;
    for (std::uint32_t i = 0; i < count; ++i) places.insert(permute(i, count, 12345 * count));
    EXPECT_EQ(places.size(), count);
    EXPECT_LT(*places.rbegin(), count);
  }
}

// Each of the 24 permutations of four is about as likely as any other.
TEST(Choice, PermutationsOfFourAreEvenlySpread) {
  std::map<std::array<std::uint32_t, 4>, int> seen;
  constexpr int kKeys = 24000;
  for (int k = 0; k < kKeys; ++k) {
    const auto key = static_cast<std::uint32_t>(mix64(1, 2, k));
    ++seen[{permute(0, 4, key), permute(1, 4, key), permute(2, 4, key), permute(3, 4, key)}];
  }
  EXPECT_EQ(seen.size(), 24u);
  for (const auto& [order, count] : seen) {
    EXPECT_GT(count, 500) << order[0] << order[1] << order[2] << order[3];
    EXPECT_LT(count, 2000);
  }
}

TEST(Choice, IsStratifiedInEachPartAndInAll) {
  Split split;
  for (const auto& [parts, points] : {std::pair(1u, 16u), {4u, 4u}, {16u, 1u}, {5u, 20u}, {8u, 8u}}) {
    split.parts = parts;
    split.points = points;
    for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
      std::set<std::uint32_t> all;
      for (std::uint32_t p = 0; p < parts; ++p) {
        std::set<std::uint32_t> own;
        for (std::uint32_t i = 0; i < points; ++i) {
          const double c = component_choice(3, pixel, p, i, split, false) * 0x1p-32;
          own.insert(static_cast<std::uint32_t>(c * points * (1 + 1e-7)));
          all.insert(static_cast<std::uint32_t>(c * points * parts * (1 + 1e-7)));
        }
        EXPECT_EQ(own.size(), points);
      }
      EXPECT_EQ(all.size(), parts * points);
    }
  }
}

// Points that choose one component are as evenly in both halves of the BSDF's set as random ones are: the
// variance of the number in one half, over that of a random half.
TEST(Choice, IsIndependentOfTheBsdfsPoints) {
  for (const char* name : {"sobol-owen", "sobol-xor", "jittered", "capcon", "ccvt"}) {
    for (const std::uint32_t count : {64u, 100u}) {
      const auto sampler = make_sampler(name, count, 5);
      double squares = 0;
      constexpr std::uint32_t kPixels = 2000;
      for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        int balance = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
          if (component_choice(5, pixel, 0, i, sampler->split(), false) >> 31) continue;
          balance += sampler->sample(pixel, i, 0, SampleDomain::disk).x >> 31 ? 1 : -1;
        }
        squares += static_cast<double>(balance) * balance / kPixels;
      }
      // Half of the points drawn without return from two even halves: variance count / 4 (1 + 1 / (count -
      // 1)).
      const double expected = count / 4.0 * count / (count - 1);
      EXPECT_NEAR(squares / expected, 1, 0.15) << name << " " << count;
    }
  }
}

}  // namespace
}  // namespace capcon
