#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>

#include "base/error.h"
#include "image/exr_rows.h"
#include "image/partial_image.h"

namespace capcon {
namespace {

class LargeImage : public ::testing::Test {
 protected:
  LargeImage() {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  ~LargeImage() override { std::filesystem::remove_all(folder_); }
  std::string file(const char* name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

std::vector<float> counting(std::size_t count, float from) {
  std::vector<float> values(count);
  std::iota(values.begin(), values.end(), from);
  return values;
}

TEST_F(LargeImage, RowsMakeTheSameFileAsTheWhole) {
  Image image(37, 50, 3);
  image.pixels = counting(image.pixels.size(), 0.25f);
  const Attributes attributes = {{"samplesPerPixel", 16}, {"sampler", std::string("capcon")}};
  write_exr(file("whole.exr"), image, attributes);
  ExrRows rows(file("rows.exr"), 37, 50, 3, attributes);
  const std::span<const float> all(image.pixels);
  for (int first = 0; first < 50;) {  // bands that do not fit the file's blocks of 16 rows
    const int count = std::min(7, 50 - first);
    rows.write(all.subspan(std::size_t(first) * 37 * 3, std::size_t(count) * 37 * 3));
    first += count;
  }
  EXPECT_FALSE(std::filesystem::exists(file("rows.exr")));
  rows.finish();
  Attributes read;
  EXPECT_EQ(read_exr(file("rows.exr"), &read).pixels, image.pixels);
  EXPECT_EQ(std::get<std::string>(read.at("sampler")), "capcon");
  EXPECT_EQ(std::filesystem::file_size(file("rows.exr")), std::filesystem::file_size(file("whole.exr")));
}

TEST_F(LargeImage, UnfinishedRowsLeaveNothing) {
  { ExrRows rows(file("a.exr"), 8, 8, 1, {}); }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_THROW(ExrRows(file("no/such/folder/a.exr"), 8, 8, 1, {}), Failure);
}

TEST_F(LargeImage, AStoppedImageGoesOn) {
  const auto a = counting(40, 1), b = counting(40, 100), c = counting(20, 500);
  {
    PartialImage partial(file("p"), 77, 10, 10, 1);
    partial.add(4, b);
    partial.add(0, a);
  }
  PartialImage partial(file("p"), 77, 10, 10, 1);
  EXPECT_TRUE(partial.has(0, 4));
  EXPECT_TRUE(partial.has(4, 4));
  EXPECT_FALSE(partial.has(0, 3));
  EXPECT_FALSE(partial.has(8, 2));
  EXPECT_EQ(partial.row_count(), 8);
  partial.add(8, c);
  std::vector<float> all;
  partial.read([&](std::span<const float> rows) { all.insert(all.end(), rows.begin(), rows.end()); });
  std::vector<float> expected = a;
  expected.insert(expected.end(), b.begin(), b.end());
  expected.insert(expected.end(), c.begin(), c.end());
  EXPECT_EQ(all, expected);
  partial.remove();
  EXPECT_FALSE(std::filesystem::exists(file("p")));
}

TEST_F(LargeImage, WhatIsCutOffOrBrokenIsDropped) {
  const auto make = [&] {
    std::filesystem::remove(file("p"));
    PartialImage partial(file("p"), 77, 10, 10, 1);
    partial.add(0, counting(40, 1));
    partial.add(4, counting(40, 100));
  };
  make();
  const auto whole = std::filesystem::file_size(file("p"));
  for (const std::uintmax_t cut :
       {1u, 159u, 170u, 175u}) {  // in the values and in the head of the second record
    make();
    std::filesystem::resize_file(file("p"), whole - cut);
    PartialImage partial(file("p"), 77, 10, 10, 1);
    EXPECT_EQ(partial.row_count(), 4) << cut;
    partial.add(4, counting(40, 100));
    EXPECT_EQ(std::filesystem::file_size(file("p")), whole);
  }
  make();
  {
    std::fstream stream(file("p"), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(whole) - 3);
    stream.put('\x55');
  }
  EXPECT_EQ(PartialImage(file("p"), 77, 10, 10, 1).row_count(), 4);
  make();
  EXPECT_EQ(PartialImage(file("p"), 78, 10, 10, 1).row_count(), 0) << "another job's rows";
}

}  // namespace
}  // namespace capcon
