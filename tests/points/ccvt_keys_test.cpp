#include "points/ccvt_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/hash.h"

namespace capcon {
namespace {

TEST(CcvtKeys, WideVectorsGiveTheSameBits) {
  const CcvtKernels plain = plain_ccvt_kernels(), best = best_ccvt_kernels();
  for (std::uint32_t count = 0; count < 150; ++count) {
    std::vector<std::uint32_t> x(count), y(count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint64_t bits = mix64(count, 1, k);
      x[k] = static_cast<std::uint32_t>(bits) >> 4;
      y[k] = static_cast<std::uint32_t>(bits >> 32) >> 4;
    }
    const TorusPoint centre{1u << 27, 4000000000u};
    std::vector<float> a(count + 1, -1), b(count + 1, -1);
    const std::uint32_t begin = count / 5;
    const float most_a =
        plain.project(x.data(), y.data(), begin, count, centre, 0.6f, -0.8f, a.data(), -3e9f);
    const float most_b = best.project(x.data(), y.data(), begin, count, centre, 0.6f, -0.8f, b.data(), -3e9f);
    EXPECT_EQ(a, b) << count;
    EXPECT_EQ(most_a, most_b) << count;
    EXPECT_EQ(a[count], -1) << "wrote beyond the end";
    float most = -3e9f;
    for (std::uint32_t k = begin; k < count; ++k) {
      const auto dx = static_cast<float>(static_cast<std::int32_t>(x[k] - centre.x));
      const auto dy = static_cast<float>(static_cast<std::int32_t>(y[k] - centre.y));
      EXPECT_EQ(a[k], dx * 0.6f + dy * -0.8f);
      most = std::max(most, a[k]);
    }
    EXPECT_EQ(most_a, most);
    std::int64_t x_a = 1, y_a = 1, x_b = 1, y_b = 1, sum_x = 0, sum_y = 0;
    double farthest = 0;
    const double far_a = plain.sum(x.data(), y.data(), count, centre, x_a, y_a);
    const double far_b = best.sum(x.data(), y.data(), count, centre, x_b, y_b);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto dx = static_cast<std::int32_t>(x[k] - centre.x),
                 dy = static_cast<std::int32_t>(y[k] - centre.y);
      sum_x += dx;
      sum_y += dy;
      farthest = std::max({farthest, std::abs(static_cast<double>(dx)), std::abs(static_cast<double>(dy))});
    }
    EXPECT_TRUE(x_a == sum_x && x_b == sum_x && y_a == sum_y && y_b == sum_y) << count;
    EXPECT_TRUE(far_a == farthest && far_b == farthest) << count;
    std::vector<CcvtCandidate> from_a(count + 1), from_b(count + 1);
    const float limit = count % 3 == 0 ? -1e10f : 0.5f * most;
    const std::uint32_t found = plain.select(a.data(), count, limit, from_a.data());
    ASSERT_EQ(found, best.select(b.data(), count, limit, from_b.data()));
    std::uint32_t expected = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (!(a[k] > limit)) continue;
      EXPECT_EQ(from_a[expected].slot, k);
      EXPECT_EQ(from_b[expected].slot, k);
      EXPECT_EQ(from_b[expected++].key, a[k]);
    }
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace capcon
