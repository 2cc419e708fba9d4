#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <array>
#include <limits>

#include "image/image.h"

namespace capcon {
namespace {

struct Decoded {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<unsigned char> bytes;
};

Decoded decode(const std::string& png) {
  Decoded d;
  stbi_uc* data = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), int(png.size()),
                                        &d.width, &d.height, &d.channels, 0);
  if (data) d.bytes.assign(data, data + d.width * d.height * d.channels);
  stbi_image_free(data);
  return d;
}

TEST(Png, GreyThroughTheSrgbCurve) {
  Image image(5, 1, 1);
  image.pixels = {0, 0.002f, 0.21404114f, 1, 7};
  const Decoded d = decode(encode_png(image));
  ASSERT_EQ(d.channels, 1);
  // 0.002 lies on the linear part: 12.92 * 0.002 * 255 = 6.59; 0.21404 is sRGB 0.5.
  EXPECT_EQ(d.bytes, (std::vector<unsigned char>{0, 7, 128, 255, 255}));
}

TEST(Png, ExposureMultipliesBeforeTheCurve) {
  Image image(1, 1, 3);
  image.pixels = {0.10702057f, 0, -1};
  EXPECT_EQ(decode(encode_png(image, 2)).bytes, (std::vector<unsigned char>{128, 0, 0}));
}

TEST(Png, RowsGoFromTheTop) {
  Image image(1, 2, 1);
  image.pixels = {1, 0};
  const Decoded d = decode(encode_png(image));
  EXPECT_EQ(d.height, 2);
  EXPECT_EQ(d.bytes, (std::vector<unsigned char>{255, 0}));
}

TEST(Png, NonFinitePixelsAreMagenta) {
  Image grey(2, 1, 1);
  grey.pixels = {1, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(decode(encode_png(grey)).bytes, (std::vector<unsigned char>{255, 255, 255, 255, 0, 255}));
  Image colour(1, 1, 3);
  colour.pixels = {0, std::numeric_limits<float>::infinity(), 0};
  EXPECT_EQ(decode(encode_png(colour)).bytes, (std::vector<unsigned char>{255, 0, 255}));
}

}  // namespace
}  // namespace capcon
