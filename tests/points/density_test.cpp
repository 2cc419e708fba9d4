#include "points/density.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace capcon {
namespace {

TEST(Density, WarpSendsEqualAreasToEqualMasses) {
  // 3 x 2 texels, one of them empty; a fine grid of u must fall into each in proportion.
  const std::vector<double> values{1, 2, 3, 0, 5, 1};
  const Density density(3, 2, values);
  const int side = 1200;
  std::vector<int> counts(6);
  double x_in_last = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::dvec2 p = density.warp({(i + 0.5) / side, (j + 0.5) / side});
      ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      const int texel = static_cast<int>(p.y * 2) * 3 + static_cast<int>(p.x * 3);
      ++counts[texel];
      if (texel == 5) x_in_last += p.x;
    }
  }
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(counts[k], values[k] / 12 * side * side, 2 * side) << k;
  EXPECT_EQ(counts[3], 0);
  EXPECT_NEAR(x_in_last / counts[5], 5. / 6, 0.002);  // even inside a texel
}

TEST(Density, WarpOfAConstantIsTheIdentity) {
  const Density density(16, 8, std::vector<double>(128, 7e250));
  for (int k = 0; k < 1000; ++k) {
    const glm::dvec2 u(std::fmod(k * 0.618034, 1.0), k / 1000.);
    EXPECT_NEAR(density.warp(u).x, u.x, 1e-12);
    EXPECT_NEAR(density.warp(u).y, u.y, 1e-12);
  }
}

TEST(Density, StiffOnesStayWhereThereIsMass) {
  std::vector<double> values(64 * 64, 0);
  values[40 * 64 + 9] = 1e-300;
  const Density spot(64, 64, values);
  EXPECT_EQ(spot.support(), std::pair(glm::dvec2(9. / 64, 40. / 64), glm::dvec2(10. / 64, 41. / 64)));
  values[63 * 64 + 63] = 1e-306;
  const Density two(64, 64, values);
  for (const double u : {0.0, 1e-300, 0.5, 1 - 0x1p-53}) {
    for (const double v : {0.0, 1e-300, 0.5, 1 - 0x1p-53}) {
      const glm::dvec2 p = spot.warp({u, v}), q = two.warp({u, v});
      EXPECT_TRUE(p.x >= 9. / 64 && p.x < 10. / 64 && p.y >= 40. / 64 && p.y < 41. / 64);
      EXPECT_TRUE(q.x < 1 && q.y < 1 && two.at(static_cast<int>(q.x * 64), static_cast<int>(q.y * 64)) > 0);
    }
  }
}

// Beyond 8192 texels 2^-40 of one is less than the rounding of a place: it rounded up to the row after the
// last.
TEST(Density, TheLastOfManyTexelsHoldsItsPlaces) {
  constexpr std::size_t kTexels = 20000;
  std::vector<double> values(kTexels, 0);
  values.back() = 1;
  for (const Density& density : {Density(1, kTexels, values), Density(kTexels, 1, values)}) {
    const glm::dvec2 p = density.warp(glm::dvec2(1 - 0x1p-53));
    EXPECT_TRUE(p.x < 1 && p.y < 1) << p.x << " " << p.y;
    EXPECT_GE(std::max(p.x, p.y), 1 - 1.0 / kTexels);
  }
}

TEST(Density, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto message = [](std::size_t w, std::size_t h, std::vector<double> values) -> std::string {
    try {
      Density density(w, h, std::move(values));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message(2, 2, {0, 0, 0, 0}), testing::HasSubstr("0 everywhere"));
  EXPECT_THAT(message(2, 2, {1, 1, -0.5, 1}), testing::HasSubstr("is -0.5 at pixel (0, 1)"));
  EXPECT_THAT(message(2, 2, {1, nan, 0, 1}), testing::HasSubstr("not a number at pixel (1, 0)"));
  EXPECT_THAT(message(1, 1, {inf}), testing::HasSubstr("is inf at pixel (0, 0)"));
  EXPECT_THAT(message(0, 2, {}), testing::HasSubstr("0 x 2 texels"));
  EXPECT_THAT(message(1 << 14, 1 << 14, {}), testing::HasSubstr("give 1 to 2^26"));
  EXPECT_THAT([] { Density::of([](double x, double) { return x - 0.1; }, 10); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("at x = 0.05, y = 0.05")));
  std::vector<double> corner(100 * 100, 0);
  corner[0] = 1;
  EXPECT_THAT([&] { Density(100, 100, corner).about_disk(); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("0 everywhere in the disk")));
}

}  // namespace
}  // namespace capcon
