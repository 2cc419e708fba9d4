#include "plot/indexed_png.h"

#include <gtest/gtest.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <cstdlib>

#include "base/hash.h"

namespace capcon::plot {
namespace {

Pixels decoded(const std::string& png) {
  Pixels pixels;
  int channels = 0;
  unsigned char* data = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                                              int(png.size()), &pixels.width, &pixels.height, &channels, 3);
  EXPECT_NE(data, nullptr) << stbi_failure_reason();
  for (int k = 0; data && k < 3 * pixels.width * pixels.height; k += 3)
    pixels.colours.push_back({data[k], data[k + 1], data[k + 2]});
  stbi_image_free(data);
  return pixels;
}

TEST(IndexedPng, FewColoursSurvive) {
  Pixels pixels{37, 23, {}};
  for (std::uint64_t i = 0; i < 37 * 23; ++i) {
    const std::uint64_t pick = mix64(1, 2, i) % 256;
    pixels.colours.push_back({std::uint8_t(pick), std::uint8_t(pick * 7), std::uint8_t(pick * 31)});
  }
  const Pixels again = decoded(encode_png(pixels));
  EXPECT_EQ(again.width, 37);
  EXPECT_EQ(again.height, 23);
  EXPECT_TRUE(again.colours == pixels.colours);
}

TEST(IndexedPng, ManyColoursStayNear) {
  // A ramp of 1024 colours on a large white ground.
  Pixels pixels{256, 32, std::vector<Colour>(256 * 32, Colour{255, 255, 255})};
  for (int k = 0; k < 1024; ++k) {
    pixels.colours[k] = {std::uint8_t(k / 4), std::uint8_t(255 - k / 4), std::uint8_t(k % 4 * 2)};
  }
  const Pixels again = decoded(encode_png(pixels));
  ASSERT_EQ(again.colours.size(), pixels.colours.size());
  EXPECT_EQ(again.colours.back(), (Colour{255, 255, 255}));
  for (int k = 0; k < 1024; ++k) {
    EXPECT_LE(std::abs(again.colours[k].r - pixels.colours[k].r), 8);
    EXPECT_LE(std::abs(again.colours[k].g - pixels.colours[k].g), 8);
  }
}

}  // namespace
}  // namespace capcon::plot
