#include "stability/deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace capcon::stability {
namespace {

Image image_of(std::initializer_list<float> values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  std::copy(values.begin(), values.end(), image.pixels.begin());
  return image;
}

TEST(Deviation, IsRelativeToThePixelOrToTheMean) {
  const Deviation d = deviation(image_of({1, 2.2f, 0, 5}), image_of({1, 2, 0.1f, 5}), 0.06);
  EXPECT_EQ(d.pixels, 4u);
  EXPECT_EQ(d.beyond, 1u);  // 0.2 of 2.025; 0.1 of the mean is 0.049
  EXPECT_NEAR(d.largest, 0.2 / 2.025, 1e-6);
  EXPECT_EQ(d.non_finite, 0u);
  EXPECT_NEAR(d.bias, 0.1 / 8.1, 1e-6);
}

TEST(Deviation, CountsWhatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Deviation d = deviation(image_of({nan, inf, 1, 1}), image_of({1, 1, 1, 1}), 1e-4);
  EXPECT_EQ(d.non_finite, 2u);
  EXPECT_EQ(d.beyond, 2u);
  EXPECT_EQ(d.largest, 0);
}

TEST(Deviation, SeesLightInABlackScene) {
  EXPECT_EQ(deviation(image_of({0, 0}), image_of({0, 0}), 1e-4).beyond, 0u);
  const Deviation d = deviation(image_of({0, 1e-20f}), image_of({0, 0}), 1e-4);
  EXPECT_EQ(d.beyond, 1u);
  EXPECT_TRUE(std::isinf(d.largest));
}

}  // namespace
}  // namespace capcon::stability
