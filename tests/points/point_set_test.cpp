#include "points/point_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"

namespace capcon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string message_of(std::string_view text) {
  try {
    parse_points(text, "p.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PointSet, ReadsSetsBetweenHashes) {
  const auto sets = parse_points("0.25 0.5\n\n \t0\t1e-3 \r\n#\n+.75 1\n#\n", "p.txt");
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0], (Points{{0.25, 0.5}, {0, 0.001}}));
  EXPECT_EQ(sets[1], (Points{{0.75, 0}}));  // 1 wraps to 0
}

TEST(PointSet, ReadsALastLineWithoutNewline) {
  EXPECT_EQ(parse_points("0.5 0.25", "p.txt"), (std::vector<Points>{{{0.5, 0.25}}}));
}

TEST(PointSet, MinusZeroIsZero) {
  EXPECT_FALSE(std::signbit(parse_points("-0 -0.0", "p.txt")[0][0].x));
}

TEST(PointSet, SaysWhereAndWhatIsWrong) {
  EXPECT_THAT(message_of("0 0\n0.5 x\n"), StartsWith("p.txt:2: \"x\" is not a number"));
  EXPECT_THAT(message_of("0 0\n\n0.5\n"), StartsWith("p.txt:3: one coordinate is missing"));
  EXPECT_THAT(message_of("0 0 0\n"), StartsWith("p.txt:1: more than two"));
  EXPECT_THAT(message_of("0 1.0000001\n"), StartsWith("p.txt:1: 1.0000001 is not in [0, 1]"));
  EXPECT_THAT(message_of("-1e-300 0\n"), HasSubstr("not in [0, 1]"));
  EXPECT_THAT(message_of("nan 0\n"), HasSubstr("not in [0, 1]"));
  EXPECT_THAT(message_of("0 inf\n"), HasSubstr("not in [0, 1]"));
  EXPECT_THAT(message_of("0 1e999\n"), HasSubstr("not in [0, 1]"));
  EXPECT_THAT(message_of("0.5,0.5\n"), HasSubstr("p.txt:1: "));
  EXPECT_THAT(message_of("0.5 0.5f\n"), HasSubstr("not a number"));
  EXPECT_THAT(message_of("0 0\n#\n#\n0 0\n"), StartsWith("p.txt:3: a set without points"));
  EXPECT_THAT(message_of("#\n0 0\n"), StartsWith("p.txt:1: a set without points"));
  EXPECT_THAT(message_of(""), StartsWith("p.txt: holds no points"));
  EXPECT_THAT(message_of(std::string("0 0\0 1\n", 7)), HasSubstr("p.txt:1: "));
}

TEST(PointSet, SurvivesTheFileBitByBit) {
  std::vector<Points> sets(2);
  for (std::uint64_t i = 0; i < 500; ++i) {
    sets[i % 2].emplace_back(uniform64(1, 2, 2 * i), std::ldexp(uniform64(1, 2, 2 * i + 1), -int(i % 60)));
  }
  sets[0].emplace_back(std::nextafter(1.0, 0.0), 5e-324);
  const auto path = std::filesystem::temp_directory_path() / ("capcon_points_" + std::to_string(::getpid()));
  write_points(path, sets);
  EXPECT_EQ(read_points(path), sets);
  EXPECT_EQ(read_file(path), format_points(sets));
  std::filesystem::remove(path);
  EXPECT_THROW(read_points(path), InputError);
}

}  // namespace
}  // namespace capcon
