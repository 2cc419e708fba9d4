#include "sampling/point_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "sampling/bits.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with the test.
class PointFileTest : public ::testing::Test {
 protected:
  PointFileTest() { fs::create_directories(folder_); }
  ~PointFileTest() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
    return "file:" + (folder_ / name).string();
  }
  /// The first n points of the Sobol' sequence.
  std::string write_sobol(const std::string& name, std::uint32_t n) const {
    Points points;
    for (std::uint32_t i = 0; i < n; ++i)
      points.emplace_back(reverse_bits(i) * 0x1p-32, reverse_bits(sobol_second_reversed(i)) * 0x1p-32);
    return write(name, format_points({points}));
  }
  const fs::path folder_ = fs::temp_directory_path() / ("capcon_point_file_" + std::to_string(::getpid()));
};

std::string message(const std::string& sampler, std::uint32_t count) {
  try {
    make_sampler(sampler, count, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<FixedPoint> set_of(const Sampler& sampler, std::uint32_t pixel, std::uint32_t dimension = 0) {
  std::vector<FixedPoint> points;
  for (std::uint32_t i = 0; i < sampler.count(); ++i) points.push_back(sampler.sample(pixel, i, dimension));
  return points;
}

TEST_F(PointFileTest, WordsBehindThePathAreUnderstood) {
  using enum PointFile::Randomisation;
  EXPECT_EQ(parse_point_file("file:a b,c.txt").path, "a b,c.txt");
  EXPECT_EQ(parse_point_file("file:C:net.txt:xor").path, "C:net.txt");
  EXPECT_EQ(parse_point_file("file:C:net.txt:xor").randomisation, xor_digits);
  const PointFile all = parse_point_file("file:a.txt:sequence:none");
  EXPECT_EQ(all.path, "a.txt");
  EXPECT_TRUE(all.sequence && all.randomisation == none);
  EXPECT_EQ(parse_point_file("file:a.txt:shift").randomisation, shift);
  for (const char* wrong : {"file:", "file::xor", "file:a.txt:xor:none"})
    EXPECT_THROW(parse_point_file(wrong), InputError) << wrong;
}

TEST_F(PointFileTest, ASetIsShiftedOnTheTorus) {
  const auto sampler = make_sampler(write("p.txt", "0 0\n0.5 0.25\n0.75 0.875\n"), 3, 7);
  std::set<std::uint32_t> shifts;
  for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
    const auto p = set_of(*sampler, pixel);
    EXPECT_EQ(FixedPoint({p[1].x - p[0].x, p[1].y - p[0].y}), FixedPoint({0x80000000u, 0x40000000u}));
    EXPECT_EQ(FixedPoint({p[2].x - p[0].x, p[2].y - p[0].y}), FixedPoint({0xc0000000u, 0xe0000000u}));
    shifts.insert(p[0].x);
  }
  EXPECT_EQ(shifts.size(), 50u);
}

// A prefix of a sequence under xor is a net for any power of two, and its parts are nets too.
TEST_F(PointFileTest, XorKeepsNetsNets) {
  const std::string sampler = write_sobol("sobol.txt", 64) + ":xor";
  for (const std::uint32_t count : {16u, 64u}) {
    const auto points = set_of(*make_sampler(sampler, count, 3, 4), 9, 2);
    for (const std::uint32_t size : {count / 4, count}) {
      std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
      const auto root = static_cast<std::uint32_t>(std::lround(std::log2(size))) / 2;
      for (std::uint32_t i = 0; i < size; ++i)
        cells.insert({points[i].x >> (32 - root), points[i].y >> (32 - root)});
      EXPECT_EQ(cells.size(), std::size_t(1) << (2 * root)) << count << " " << size;
    }
  }
}

TEST_F(PointFileTest, OfSeveralSetsEachIsUsed) {
  const std::string file = write("sets.txt", "0.25 0.25\n0.5 0.5\n#\n0.125 0.75\n0.75 0.5\n#\n0.5 0\n");
  const auto sampler = make_sampler(file + ":none", 2, 5);  // the set of one point has too few
  int first = 0;
  for (std::uint32_t pixel = 0; pixel < 1000; ++pixel) {
    const auto p = set_of(*sampler, pixel);
    const bool is_first =
        p[0] == FixedPoint{0x40000000u, 0x40000000u} && p[1] == FixedPoint{0x80000000u, 0x80000000u};
    const bool is_second =
        p[0] == FixedPoint{0x20000000u, 0xc0000000u} && p[1] == FixedPoint{0xc0000000u, 0x80000000u};
    ASSERT_TRUE(is_first != is_second);
    first += is_first ? 1 : 0;
  }
  EXPECT_NEAR(first, 500, 5 * 15.8);
  // Sets of just so many points go before beginnings of longer ones.
  EXPECT_THAT(message(file + ":none", 1), testing::HasSubstr("every pixel would have the same points"));
}

TEST_F(PointFileTest, ASetThatIsSplitIsPartedLikeCcvts) {
  std::string text;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) text += std::to_string(x / 4.0) + " " + std::to_string(y / 4.0) + "\n";
  }
  const auto spacing = [&](const std::string& sampler) {  // of the first of four parts, on the torus
    const auto points = set_of(*make_sampler(sampler, 16, 1, 4), 0);
    double least = 1;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto x = static_cast<std::int32_t>(points[i].x - points[j].x),
                   y = static_cast<std::int32_t>(points[i].y - points[j].y);
        least = std::min(least, std::hypot(x, y) * 0x1p-32);
      }
    }
    return least;
  };
  const std::string grid = write("grid.txt", text);
  EXPECT_NEAR(spacing(grid + ":sequence"), 0.25, 1e-6);
  EXPECT_GT(spacing(grid), 0.49);
}

TEST_F(PointFileTest, WhatIsWrongIsOneSentence) {
  const std::string few = write("few.txt", "0 0\n0.5 0.5\n#\n0.25 0\n");
  EXPECT_THAT(message(few, 4), testing::HasSubstr("4 points are asked for, and its largest set has 2"));
  EXPECT_THAT(message(write("out.txt", "0 0\n0.5 1.5\n"), 1),
              testing::HasSubstr("out.txt:2: 1.5 is not in [0, 1]"));
  EXPECT_THAT(message("file:/no/such.txt", 1), testing::HasSubstr("/no/such.txt: cannot open"));
  EXPECT_THROW(check_sampler("file:/no/such.txt"), InputError);
  EXPECT_THROW(check_sampler("file:/no/such-{n}.txt"), InputError);
  EXPECT_THROW(check_sampler("halotn"), InputError);
  EXPECT_NO_THROW(check_sampler(few));
  for (const char* known : {"ccvt", "capcon-bounded", "capcon-screen"})
    EXPECT_NO_THROW(check_sampler(known)) << known;
}

TEST_F(PointFileTest, ANumberInTheNameChoosesTheFile) {
  write("p2.txt", "0.25 0.25\n0.5 0.5\n");
  write("p1.txt", "0.5 0\n");
  write("pages.txt", "no points at all");
  const std::string pattern = "file:" + (folder_ / "p{n}.txt").string();
  EXPECT_NO_THROW(check_sampler(pattern));
  const auto p = set_of(*make_sampler(pattern, 2, 1), 0);
  EXPECT_EQ(p[1].x - p[0].x, 0x40000000u);
  EXPECT_THAT(message(pattern, 3), testing::HasSubstr("p3.txt: cannot open"));
  const std::uint64_t before = point_file_fingerprint(pattern);
  EXPECT_EQ(before, point_file_fingerprint(pattern));
  write("p1.txt", "0.5 0.5\n");
  EXPECT_NE(before, point_file_fingerprint(pattern));
  EXPECT_EQ(point_file_fingerprint("ccvt"), 0u);
}

TEST_F(PointFileTest, LabelsAreSafeAndApart) {
  EXPECT_EQ(sampler_label("sobol-owen"), "sobol-owen");
  EXPECT_EQ(sampler_label("file:/a/long way/my points, 2.txt"), "my_points__2");
  EXPECT_EQ(sampler_label("file:net.txt:xor"), "net-xor");
  EXPECT_EQ(sampler_label("file:a/ccvt-{n}.txt"), "ccvt-n");
  EXPECT_EQ(sampler_label("file:a/ccvt.txt"), "ccvt-file");
  EXPECT_EQ(sampler_label("file:" + std::string(300, 'x') + ".csv"), std::string(40, 'x'));
  EXPECT_EQ(sampler_labels({"file:a/p.txt", "ccvt", "file:b/p.txt", "file:b/p.txt:xor"}),
            (std::vector<std::string>{"p", "ccvt", "p-2", "p-xor"}));
}

}  // namespace
}  // namespace capcon
