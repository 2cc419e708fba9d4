#include "sampling/parts_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/little_endian.h"
#include "sampling/parts_store.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

std::string shipped_bytes() {
  return read_file(shipped_file("tiles/c2n16.parts"));
}

/// With the checksum that belongs to it.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  put_bytes(bytes, fnv1a64(bytes));
  return bytes;
}

std::string complaint(const std::string& bytes) {
  try {
    parse_parts(bytes, "some.parts");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// Shipped data of this test's own, while it lives: the shipped tile set and, where given, parts.
class OtherData {
 public:
  OtherData()  // a name a test: they run side by side
      : folder_(
            fs::path(testing::TempDir()) /
            (std::string("capcon-parts-") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    const std::string tiles = read_file(shipped_file("tiles/c2n16.tiles"));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "tiles");
    write_file(folder_ / "tiles/c2n16.tiles", tiles);
    if (const char* old = std::getenv("CAPCON_DATA")) old_ = old;
    setenv("CAPCON_DATA", folder_.c_str(), 1);
  }
  ~OtherData() {
    if (old_.empty()) {
      unsetenv("CAPCON_DATA");
    } else {
      setenv("CAPCON_DATA", old_.c_str(), 1);
    }
    fs::remove_all(folder_);
  }
  void write_parts(const std::string& bytes) const { write_file(folder_ / "tiles/c2n16.parts", bytes); }

 private:
  fs::path folder_;
  std::string old_;
};

std::vector<std::pair<std::uint32_t, std::uint32_t>> first_set(std::uint32_t count, std::uint32_t parts) {
  const auto sampler = make_sampler("capcon", count, 3, parts);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    const FixedPoint p = sampler->sample(0, i, 0);
    points.emplace_back(p.x, p.y);
  }
  return points;
}

class ShippedParts : public testing::TestWithParam<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Counts, ShippedParts, testing::Values(16, 32, 64, 128, 256));

TEST_P(ShippedParts, AreThoseThatAreMade) {
  const PartsFile file = parse_parts(shipped_bytes(), "shipped");
  const TileSet set = shipped_tile_set();
  EXPECT_EQ(file.tiles, checksum(set));
  const std::uint32_t count = GetParam();
  const TilingCut cut = choose_cut(count, set.points_per_tile);
  const GaussianTiling tiling(cut.a, cut.b);
  std::uint32_t parts = 2;
  for (const StoredParts& s : file.splits) {
    if (s.count != count) continue;
    EXPECT_EQ(s.parts, parts);
    EXPECT_EQ(s.dealt, make_tiling_parts(set, tiling, cell_points(cut, tiling), s.parts)) << s.parts;
    parts *= 2;
  }
  EXPECT_EQ(parts, 2 * count) << "all splits down to parts of one point";
}

TEST(PartsFile, IsSmallAndWrittenAsItIsRead) {
  const std::string bytes = shipped_bytes();
  EXPECT_LT(bytes.size(), 20000u);
  const PartsFile file = parse_parts(bytes, "shipped");
  EXPECT_EQ(file.splits.size(), shipped_splits().size());
  EXPECT_EQ(format_parts(file), bytes);
}

TEST(PartsFile, RefusesWhatIsBroken) {
  const std::string bytes = shipped_bytes();
  EXPECT_EQ(complaint(bytes), "none");
  for (std::size_t length = 0; length < bytes.size(); length += length < 200 ? 1 : 97)
    EXPECT_NE(complaint(bytes.substr(0, length)), "none") << length;
  for (std::size_t at = 0; at < bytes.size(); at += at < 200 ? 1 : 97) {
    std::string other = bytes;
    other[at] = char(other[at] ^ 0x10);
    EXPECT_NE(complaint(other), "none") << at;
  }
  using testing::HasSubstr;
  EXPECT_THAT(complaint("P6 16 16 255"), HasSubstr("do not begin with CAPPARTS"));
  EXPECT_THAT(complaint(bytes.substr(0, 9000)), HasSubstr("wrong checksum"));
  EXPECT_THAT(complaint(bytes.substr(0, 9000)), HasSubstr("capcon tiles parts -o FILE"));
  std::string other = bytes;
  other[8] = 2;
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("another version"));
  other = bytes;
  other[20] = char(other[20] + 1);  // one split more than there are
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("cut short"));
  other = bytes;
  other[20] = char(other[20] - 1);
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("followed by more"));
  other = bytes;
  other[44] = other[45];  // the first order
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("every point once"));
  other = bytes;
  other[28] = 3;  // parts of 16 points
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("equal parts"));
  other = bytes;
  other[25] = 16;  // more points than a byte can number
  EXPECT_THAT(complaint(sealed(other)), HasSubstr("sizes"));
}

TEST(PartsFile, IsWhatTheSamplerTakes) {
  const auto shipped = first_set(64, 4), many = first_set(128, 4);
  const PartsFile file = parse_parts(shipped_bytes(), "shipped");
  const OtherData data;
  // None, of another tile set, without the split, for another tiling: made, and the same.
  EXPECT_EQ(first_set(64, 4), shipped);
  EXPECT_EQ(first_set(128, 4), many);
  PartsFile other = file;
  for (StoredParts& s : other.splits)
    for (auto& order : s.dealt.orders) std::swap(order[0], order[1]);
  const PartsFile swapped = other;
  other.tiles ^= 1;
  data.write_parts(format_parts(other));
  EXPECT_EQ(first_set(64, 4), shipped);
  data.write_parts(format_parts({file.tiles, {}}));
  EXPECT_EQ(first_set(64, 4), shipped);
  other = swapped;
  for (StoredParts& s : other.splits) s.dealt.orders.resize(3, s.dealt.orders[0]);
  data.write_parts(format_parts(other));
  EXPECT_EQ(first_set(64, 4), shipped);
  EXPECT_EQ(first_set(128, 4), many);
  // What fits is taken as it is.
  data.write_parts(format_parts(swapped));
  for (auto expected : {shipped, many}) {
    std::swap(expected[0], expected[1]);
    EXPECT_EQ(first_set(std::uint32_t(expected.size()), 4), expected);
  }
  data.write_parts(format_parts(file).substr(0, 100));
  EXPECT_THROW(first_set(64, 4), InputError);
  EXPECT_EQ(first_set(64, 1).size(), 64u) << "one part needs no file";
}

}  // namespace
}  // namespace capcon
