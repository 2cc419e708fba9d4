#include "points/ccvt_circles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/hash.h"

namespace capcon {
namespace {

/// Circles crowded in a corner, and a few large ones anywhere: brute force over all pairs finds the same.
TEST(CcvtCircleTree, FindsEachOverlappingPairOnce) {
  constexpr std::uint32_t kCount = 400;
  std::vector<CcvtCircle> circles;
  std::vector<float> slacks;
  std::vector<std::uint8_t> seeks;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const std::uint64_t bits = mix64(5, 1, i);
    const int crowd = i % 20 == 0 ? 0 : 8;  // most within 1/256 of the torus about (0, 0), where it wraps
    const auto offset = [&](std::uint64_t b) {
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<std::uint32_t>(b)) >> crowd);
    };
    const double size = 0x1p-32 * static_cast<double>(mix64(5, 2, i) >> 32);
    circles.push_back(
        {{offset(bits), offset(bits >> 32)}, static_cast<float>(size * (crowd ? 0x1p20 : 0x1p30))});
    slacks.push_back(0.1f * circles.back().radius);
    seeks.push_back(i % 3 != 0);
  }
  const CcvtCircleTree tree(circles, slacks, seeks);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found, expected;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    if (!seeks[i]) continue;
    tree.overlaps(i, [&](std::uint32_t j) { found.emplace_back(std::min(i, j), std::max(i, j)); });
  }
  for (std::uint32_t i = 0; i < kCount; ++i) {
    for (std::uint32_t j = i + 1; j < kCount; ++j) {
      if (!seeks[i] && !seeks[j]) continue;
      const auto gap = [](std::uint32_t a, std::uint32_t b) { return std::remainder(double(a) - b, 0x1p32); };
      const double distance = std::hypot(gap(circles[i].centre.x, circles[j].centre.x),
                                         gap(circles[i].centre.y, circles[j].centre.y));
      if (distance < 1.1 * (double(circles[i].radius) + circles[j].radius)) expected.emplace_back(i, j);
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_GT(expected.size(), kCount);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace capcon
