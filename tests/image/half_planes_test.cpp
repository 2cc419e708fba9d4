#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic ignored "-Wunused-function"
#include "image/half_planes.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <cmath>

namespace capcon {
namespace {

/// As page/viewer.js has it.
float half(unsigned bits) {
  const float sign = bits & 0x8000 ? -1 : 1;
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  if (exponent == 31) return fraction ? NAN : sign * INFINITY;
  return sign * (exponent ? std::ldexp(1 + static_cast<float>(fraction) / 1024, exponent - 15)
                          : std::ldexp(static_cast<float>(fraction) / 1024, -14));
}

TEST(HalfPlanes, KeepElevenBits) {
  Image a(3, 2, 1), b(3, 2, 1);
  a.pixels = {0, 1, -2.5f, 1e-7f, 0.333f, 1000.7f};
  b.pixels = {6.1e-5f, 65504, 1e9f, 0.1f, 3e-6f, 0.999f};
  const std::string packed = half_planes({&a, &b});
  int length = 0;
  char* bytes = stbi_zlib_decode_malloc(packed.data(), static_cast<int>(packed.size()), &length);
  ASSERT_NE(bytes, nullptr);
  ASSERT_EQ(length, 24);
  for (int i = 0; i < 12; ++i) {
    const float want = i < 6 ? a.pixels[i] : b.pixels[i - 6];
    const auto high = static_cast<unsigned char>(bytes[i]), low = static_cast<unsigned char>(bytes[12 + i]);
    const float got = half(high << 8 | low);
    if (want > 65519) {
      EXPECT_TRUE(std::isinf(got));
    } else {
      EXPECT_NEAR(got, want, std::max(6e-8, std::abs(want) / 2048.0)) << i;
    }
  }
  stbi_image_free(bytes);
}

}  // namespace
}  // namespace capcon
