#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <limits>

#include "base/error.h"
#include "base/file.h"
#include "image/image.h"

namespace capcon {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of its own for every test.
class Exr : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("capcon_exr_" + std::to_string(::getpid()) +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string message_of_reading(const fs::path& path) {
    try {
      read_exr(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }
  fs::path folder_;
};

/// Values no format but float32 keeps: denormals, huge and tiny, negative zero, infinities, NaN.
Image awkward_image(int channels) {
  Image image(31, 53, channels);
  const float special[] = {0x1p-149f,
                           -0.0f,
                           3.4e38f,
                           1.0f / 3,
                           std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN(),
                           -1e-30f};
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % 11 < 7 ? special[i % 11] : float(i) * 0.1f;
  return image;
}

void expect_same_bits(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.channels, b.channels);
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(a.pixels[i]), std::bit_cast<std::uint32_t>(b.pixels[i]))
        << "value " << i;
  }
}

TEST_F(Exr, RoundTripKeepsEveryBit) {
  for (int channels : {1, 3}) {
    const Image image = awkward_image(channels);
    write_exr(folder_ / "a.exr", image);
    expect_same_bits(image, read_exr(folder_ / "a.exr"));
  }
}

TEST_F(Exr, RoundTripKeepsAttributes) {
  const Attributes written{{"samplesPerPixel", 64},
                           {"renderTimeSeconds", 1.25f},
                           {"sampler", std::string("capcon")},
                           {"timings", std::string("{\"wall\":{}}")},
                           {"seed", -3}};
  write_exr(folder_ / "a.exr", Image(2, 2, 1), written);
  Attributes read;
  read_exr(folder_ / "a.exr", &read);
  EXPECT_EQ(read, written);
}

/// Writes channels of any kind with OpenEXR itself; value of channel k at (x, y) of the window: 100 k + 10 y
/// + x.
void write_foreign(const fs::path& path, const Imath::Box2i& window, const std::vector<const char*>& names,
                   Imf::PixelType type, bool tiled) {
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  Imf::Header header(Imath::Box2i({0, 0}, {63, 63}), window);
  header.compression() = Imf::PIZ_COMPRESSION;
  Imf::FrameBuffer frame;
  std::vector<std::vector<char>> planes;
  const std::size_t size = type == Imf::HALF ? 2 : 4;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<char>& plane = planes.emplace_back(size * width * height);
    for (int i = 0; i < width * height; ++i) {
      const int v = 100 * int(k) + 10 * (i / width) + i % width;
      if (type == Imf::HALF) reinterpret_cast<half*>(plane.data())[i] = half(float(v));
      if (type == Imf::FLOAT) reinterpret_cast<float*>(plane.data())[i] = float(v);
      if (type == Imf::UINT) reinterpret_cast<unsigned*>(plane.data())[i] = unsigned(v);
    }
    header.channels().insert(names[k], Imf::Channel(type));
    frame.insert(names[k], Imf::Slice::Make(type, plane.data(), window, size, size * width));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(4, 4, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
}

TEST_F(Exr, ReadsEveryPixelTypeLayoutAndWindow) {
  for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
    for (const bool tiled : {false, true}) {
      // The data window begins outside the display window, as renderers' crop windows do.
      write_foreign(folder_ / "a.exr", {{-5, 7}, {3, 12}}, {"R", "G", "B", "A", "light.R"}, type, tiled);
      const Image image = read_exr(folder_ / "a.exr");
      ASSERT_EQ(image.width, 9);
      ASSERT_EQ(image.height, 6);
      ASSERT_EQ(image.channels, 3);
      for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 9; ++x) {
          for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y, c), 100 * c + 10 * y + x) << type << tiled;
        }
      }
    }
  }
}

TEST_F(Exr, PicksTheChannel) {
  const auto channel_read = [&](const std::vector<const char*>& names) {
    write_foreign(folder_ / "a.exr", {{0, 0}, {2, 2}}, names, Imf::FLOAT, false);
    return read_exr(folder_ / "a.exr").at(0, 0, 0) / 100;
  };
  EXPECT_EQ(channel_read({"A", "Y"}), 1);
  EXPECT_EQ(channel_read({"ao"}), 0);
  EXPECT_EQ(channel_read({"A"}), 0);
  EXPECT_EQ(channel_read({"layer.Y", "A", "Z"}), 2);
  write_foreign(folder_ / "b.exr", {{0, 0}, {2, 2}}, {"U", "V"}, Imf::FLOAT, false);
  EXPECT_THAT(message_of_reading(folder_ / "b.exr"), HasSubstr("U, V"));
}

TEST_F(Exr, RefusesWhatIsNoExr) {
  EXPECT_THAT(message_of_reading(folder_ / "none.exr"), HasSubstr("none.exr"));
  EXPECT_THAT(message_of_reading(folder_), HasSubstr("directory"));
  write_file(folder_ / "text.exr", "P6 10 10 255");
  EXPECT_THAT(message_of_reading(folder_ / "text.exr"), HasSubstr("not an EXR"));
  write_file(folder_ / "empty.exr", "");
  EXPECT_THAT(message_of_reading(folder_ / "empty.exr"), HasSubstr("not an EXR"));
}

TEST_F(Exr, EveryTruncationIsReported) {
  write_exr(folder_ / "a.exr", awkward_image(3));
  const std::string bytes = read_file(folder_ / "a.exr");
  for (std::size_t size = 0; size < bytes.size(); size += size < 600 ? 1 : 97) {
    write_file(folder_ / "cut.exr", bytes.substr(0, size));
    EXPECT_THAT(message_of_reading(folder_ / "cut.exr"), HasSubstr("cut.exr"))
        << size << " of " << bytes.size();
  }
}

TEST_F(Exr, NoCorruptByteCrashes) {
  write_exr(folder_ / "a.exr", awkward_image(3), {{"sampler", std::string("capcon")}});
  const std::string bytes = read_file(folder_ / "a.exr");
  int refused = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 800); ++i) {
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string broken = bytes;
      broken[i] ^= flip;
      write_file(folder_ / "b.exr", broken);
      refused += message_of_reading(folder_ / "b.exr") != "no InputError";
    }
  }
  EXPECT_GT(refused, 500);  // many bytes are names and pixels, which may change without breaking the file
}

TEST_F(Exr, RefusesHugeSizesBeforeAllocating) {
  write_exr(folder_ / "a.exr", Image(8, 8, 1));
  std::string bytes = read_file(folder_ / "a.exr");
  const std::size_t window = bytes.find(std::string("dataWindow\0box2i\0", 17)) + 17 + 4;
  for (int i : {8, 9, 12, 13}) bytes[window + i] = '\xff';  // 65536 x 65536
  write_file(folder_ / "huge.exr", bytes);
  EXPECT_THAT(message_of_reading(folder_ / "huge.exr"), HasSubstr("65536 x 65536"));
}

TEST_F(Exr, UnwritableOutputLeavesNothing) {
  EXPECT_THROW(write_exr(folder_ / "missing" / "a.exr", Image(2, 2, 1)), Failure);
  fs::create_directories(folder_ / "taken.exr" / "inside");
  EXPECT_THROW(write_exr(folder_ / "taken.exr", Image(2, 2, 1)), Failure);
  EXPECT_THROW(write_png(folder_ / "missing" / "a.png", Image(2, 2, 1)), Failure);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Exr, ADiskThatFillsUpLeavesTheOlderFile) {
  write_exr(folder_ / "a.exr", Image(2, 2, 1));
  const std::string older = read_file(folder_ / "a.exr");
  // A limit on the size of files stands in for the full disk: write() fails half way with a reason.
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{4096, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_exr(folder_ / "a.exr", awkward_image(3)), Failure);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(read_file(folder_ / "a.exr"), older);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST(Anchors, ReferenceImagesLoad) {
  const fs::path folder = fs::path(CAPCON_SHARED_DIR) / "anchors" / "ref";
  if (!fs::exists(folder)) GTEST_SKIP() << "no anchor images at " << folder;
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const Image image = read_exr(entry.path());
    EXPECT_EQ(image.channels, 3) << entry.path();
    EXPECT_EQ(image.width, image.height);
    double sum = 0;
    for (float v : image.pixels) sum += v;
    const double mean = sum / double(image.pixels.size());
    EXPECT_GT(mean, 0.01) << entry.path();
    EXPECT_LT(mean, 10) << entry.path();
    ++seen;
  }
  EXPECT_GE(seen, 10);
}

}  // namespace
}  // namespace capcon
