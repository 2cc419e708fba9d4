#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "image/image.h"

namespace capcon {
namespace {

class ReadPng : public testing::Test {
 protected:
  ~ReadPng() override { std::filesystem::remove(path_); }
  Image read(const std::string& bytes) {
    write_file(path_, bytes);
    return read_png(path_);
  }
  std::string message(const std::string& bytes) {
    try {
      read(bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("capcon_read_png_" + std::to_string(::getpid()) + ".png");
};

// Written by another encoder (Python's zlib): 2 x 1 pixels, 16 bits grey, values 0x1234 and 0xffff.
const unsigned char kGrey16[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d,
                                 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01,
                                 0x10, 0x00, 0x00, 0x00, 0x00, 0x81, 0xd9, 0xfc, 0x15, 0x00, 0x00, 0x00,
                                 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x10, 0x32, 0xf9, 0xff,
                                 0x1f, 0x00, 0x03, 0xe6, 0x02, 0x45, 0x2e, 0x42, 0x96, 0x75, 0x00, 0x00,
                                 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

TEST_F(ReadPng, GivesBackWhatWasWritten) {
  Image image(7, 5, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = float(i) / float(image.pixels.size());
  const Image again = read(encode_png(image));
  ASSERT_EQ(again.width, 7);
  ASSERT_EQ(again.height, 5);
  ASSERT_EQ(again.channels, 3);
  // One step of sRGB is at most 2.4 / 255 wide in linear values, half of it is the rounding.
  for (std::size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(again.pixels[i], image.pixels[i], 0.005);
}

TEST_F(ReadPng, GreyStaysOneChannelAndLinear) {
  Image image(3, 1, 1);
  image.pixels = {0, 0.21404114f, 1};
  const Image again = read(encode_png(image));
  ASSERT_EQ(again.channels, 1);
  EXPECT_EQ(again.pixels[0], 0);
  EXPECT_NEAR(again.pixels[1], 0.2158605, 1e-6);  // 128 / 255 through the curve
  EXPECT_EQ(again.pixels[2], 1);
}

TEST_F(ReadPng, ReadsSixteenBits) {
  const Image image = read(std::string(reinterpret_cast<const char*>(kGrey16), sizeof kGrey16));
  ASSERT_EQ(image.width, 2);
  ASSERT_EQ(image.channels, 1);
  EXPECT_NEAR(image.pixels[0], std::pow((0x1234 / 65535. + 0.055) / 1.055, 2.4), 1e-7);
  EXPECT_EQ(image.pixels[1], 1);
}

TEST_F(ReadPng, RefusesWhatIsBroken) {
  const std::string good = encode_png(Image(40, 40, 3));
  EXPECT_THROW(read_png("/nonexistent.png"), InputError);
  EXPECT_THAT(message(""), testing::HasSubstr("is not a PNG"));
  EXPECT_THAT(message("P5 1 1 255 x"), testing::HasSubstr("is not a PNG"));
  for (std::size_t length = 8; length + 12 < good.size(); ++length)
    EXPECT_THAT(message(good.substr(0, length)), testing::HasSubstr("cannot be read as a PNG")) << length;
}

TEST_F(ReadPng, RefusesHugeSizesBeforeAllocating) {
  std::string huge = encode_png(Image(1, 1, 1));
  for (const std::size_t at : {18u, 22u}) huge[at] = '\x30';  // 12289 squared pixels in the header
  EXPECT_THAT(message(huge), testing::HasSubstr("more than 2^26"));
}

}  // namespace
}  // namespace capcon
