#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace capcon {
namespace {

Image image_of(int width, int height, int channels, std::vector<float> pixels) {
  Image image(width, height, channels);
  image.pixels = std::move(pixels);
  return image;
}

TEST(Compare, HandComputed) {
  const Image a = image_of(2, 1, 1, {0.5f, 2.0f});
  const Image b = image_of(2, 1, 1, {0.25f, 0.5f});
  const Comparison c = compare(a, b, 1.0);
  EXPECT_DOUBLE_EQ(c.mse, (0.0625 + 2.25) / 2);
  EXPECT_DOUBLE_EQ(c.mse_clamped, (0.0625 + 0.25) / 2);
  EXPECT_DOUBLE_EQ(c.relmse, (0.0625 / (0.0625 + 0.01) + 2.25 / (0.25 + 0.01)) / 2);
  EXPECT_DOUBLE_EQ(c.max_difference, 1.5);
  EXPECT_DOUBLE_EQ(c.mean_difference, 0.875);
  EXPECT_DOUBLE_EQ(c.beyond, 0.5);
  EXPECT_EQ(c.non_finite, 0u);
}

TEST(Compare, SignOfTheMeanAndRoleOfTheReference) {
  const Image a = image_of(1, 1, 1, {0.0f});
  const Image b = image_of(1, 1, 1, {1.0f});
  EXPECT_DOUBLE_EQ(compare(a, b).mean_difference, -1);
  EXPECT_DOUBLE_EQ(compare(a, b).relmse, 1 / 1.01);
  EXPECT_DOUBLE_EQ(compare(b, a).relmse, 1 / 0.01);
}

TEST(Compare, GreyStandsForThreeEqualChannels) {
  const Image grey = image_of(2, 1, 1, {0.5f, 0.25f});
  const Image same = image_of(2, 1, 3, {0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.25f});
  EXPECT_EQ(compare(grey, same).mse, 0);
  const Image red = image_of(2, 1, 3, {1.0f, 0.5f, 0.5f, 0.25f, 0.25f, 0.25f});
  EXPECT_DOUBLE_EQ(compare(grey, red).mse, 0.25 / 6);
  EXPECT_DOUBLE_EQ(compare(red, grey).mse, 0.25 / 6);
  EXPECT_DOUBLE_EQ(compare(red, grey).beyond, 0.5);
}

TEST(Compare, TrimmedLeavesOutTheWorstHundredth) {
  // 250 pixels: two are left out. Errors: three pixels of difference 10, 8, 6 and the rest 1.
  Image a(25, 10, 1);
  const Image b(25, 10, 1);
  for (float& v : a.pixels) v = 1;
  a.pixels[17] = -10;
  a.pixels[203] = 8;
  a.pixels[99] = 6;
  EXPECT_DOUBLE_EQ(compare(a, b).mse_trimmed, (247 + 36) / 248.0);
  EXPECT_DOUBLE_EQ(compare(a, b).mse, (247 + 36 + 64 + 100) / 250.0);
}

TEST(Compare, TrimmedJudgesAPixelByTheMeanOverItsChannels) {
  Image a(10, 10, 3);
  const Image b(10, 10, 3);
  for (int c = 0; c < 3; ++c) a.at(2, 2, c) = 2;  // mean error 4: the worst pixel
  a.at(5, 5, 0) = 3;                              // mean error 3, though its worst channel is larger
  EXPECT_DOUBLE_EQ(compare(a, b).mse_trimmed, 3.0 / 99);
}

TEST(Compare, SmallImagesAreNotTrimmed) {
  const Image a = image_of(2, 1, 1, {1, 3});
  EXPECT_DOUBLE_EQ(compare(a, Image(2, 1, 1)).mse_trimmed, 5);
}

TEST(Compare, NonFinitePixelsAreCountedAndLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const Image a = image_of(4, 1, 1, {nan, 1, 1, 1});
  const Image b = image_of(4, 1, 3, {0, 0, 0, 0, inf, 0, 0.5f, 0.5f, 0.5f, 1, 1, 1});
  const Comparison c = compare(a, b);
  EXPECT_EQ(c.non_finite, 2u);
  EXPECT_DOUBLE_EQ(c.mse, 0.125);
  EXPECT_DOUBLE_EQ(c.beyond, 0.5);
}

TEST(Compare, NothingFiniteIsNotZeroError) {
  const Image a = image_of(1, 1, 1, {std::numeric_limits<float>::quiet_NaN()});
  const Comparison c = compare(a, Image(1, 1, 1));
  EXPECT_TRUE(std::isnan(c.mse));
  EXPECT_TRUE(to_json(c)["mse"].dump() == "null");
  EXPECT_EQ(c.non_finite, 1u);
}

TEST(Compare, ToleranceIsInclusive) {
  const Image a = image_of(1, 1, 1, {0.5f});
  EXPECT_EQ(compare(a, Image(1, 1, 1), 0.5).beyond, 0);
  EXPECT_EQ(compare(a, Image(1, 1, 1), 0.49).beyond, 1);
}

TEST(Compare, RefusesOtherSizes) {
  EXPECT_THROW(compare(Image(2, 1, 1), Image(1, 2, 1)), InputError);
  EXPECT_THROW(compare(Image(2, 1, 2), Image(2, 1, 3)), InputError);
}

TEST(Compare, JsonHoldsEveryNumber) {
  const auto json = to_json(compare(image_of(1, 1, 1, {0.5f}), Image(1, 1, 1)));
  EXPECT_EQ(json.size(), 9u);
  EXPECT_EQ(json["mse"], 0.25);
  EXPECT_EQ(json["tolerance"], 1e-4);
}

}  // namespace
}  // namespace capcon
