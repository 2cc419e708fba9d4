#include "tiling/tile_set.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "tiling/region_layout.h"
#include "tiling/tied_points.h"

namespace capcon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TileSet shared_set() {
  return to_tile_set(random_tied_points(2, 16, region_counts(16), 3), "a test");
}

std::string sealed(std::string body) {
  return body + fmt::format("checksum fnv1a64 {:016x}\n", fnv1a64(body));
}

// The text with the first `from` replaced, sealed again with the right checksum.
std::string edited(const TileSet& set, const std::string& from, const std::string& to) {
  std::string text = format_tile_set(set);
  text.resize(text.find("checksum"));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return sealed(text.replace(at, from.size(), to));
}

std::string message(const std::string& text) {
  try {
    parse_tile_set(text, "my.tiles");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TileSet, RoundTripKeepsEveryBit) {
  for (const std::uint32_t colours : {1u, 2u, 3u}) {
    const TileSet set =
        to_tile_set(random_tied_points(colours, 20, {2, 1, 8}, colours), "a recipe, with words");
    const TileSet back = parse_tile_set(format_tile_set(set), "x");
    EXPECT_EQ(format_tile_set(back), format_tile_set(set));
    EXPECT_EQ(back.recipe, set.recipe);
    EXPECT_EQ(back.tile_count(), colours * colours * colours * colours);
    EXPECT_EQ(back.tiles.back().back().position, set.tiles.back().back().position);
  }
}

TEST(TileSet, WrongFirstLines) {
  EXPECT_THAT(message(""), StartsWith("my.tiles:1: the file ends here"));
  EXPECT_THAT(message("ply\n"), StartsWith("my.tiles:1: not a tile set"));
  EXPECT_THAT(message("capcon-tiles 4\n"), StartsWith("my.tiles:1: version '4'"));
  EXPECT_THAT(message(edited(shared_set(), "colours 2", "colours two")),
              StartsWith("my.tiles:2: 'two' is not"));
  EXPECT_THAT(message(edited(shared_set(), "colours 2", "colours 0")),
              StartsWith("my.tiles:2: colours must be"));
  EXPECT_THAT(message(edited(shared_set(), "colours 2", "colours 99999999")),
              StartsWith("my.tiles:2: colours must"));
  EXPECT_THAT(message(edited(shared_set(), "points 16", "points 17")),
              StartsWith("my.tiles:22: 'tile' is not"));
  EXPECT_THAT(message(edited(shared_set(), "points 16", "points 15")),
              StartsWith("my.tiles:21: 'tile 1' should"));
  EXPECT_THAT(message(edited(shared_set(), "recipe", "receipt")), StartsWith("my.tiles:4: "));
}

TEST(TileSet, ChangedBytesAreFound) {
  std::string text = format_tile_set(shared_set());
  text[text.find("tile 3\n") + 8] ^= 1;
  EXPECT_THAT(message(text), HasSubstr("checksum should be"));
  EXPECT_THAT(message(format_tile_set(shared_set()) + "more\n"), HasSubstr("nothing may follow"));
}

TEST(TileSet, EveryTruncationIsFound) {
  const std::string text = format_tile_set(shared_set());
  for (std::size_t size = 0; size < text.size(); size += 7)
    EXPECT_THAT(message(text.substr(0, size)), StartsWith("my.tiles:")) << size;
  EXPECT_THAT(message(text.substr(0, text.size() - 1)), HasSubstr("truncated"));
}

TEST(TileSet, PointsMustBeNumbersAndKnownRegions) {
  EXPECT_THAT(message(edited(shared_set(), " corner 0 0", " corner 0 -1")),
              StartsWith("my.tiles:6: '-1' is not"));
  EXPECT_THAT(message(edited(shared_set(), " corner 0 0", " korner 0 0")),
              StartsWith("my.tiles:6: 'korner' is no"));
  EXPECT_THAT(message(edited(shared_set(), " corner 0 0", " corner 0 0 1")),
              StartsWith("my.tiles:6: '1' is too"));
  EXPECT_THAT(message(edited(shared_set(), " corner 0 0", " corner 0")), StartsWith("my.tiles:6: '' is not"));
}

TEST(TileSet, CopiesOfRegionsMustAgree) {
  TileSet moved = shared_set();
  moved.tiles[5][0].position.x ^= 1;
  EXPECT_THAT(message(format_tile_set(moved)), HasSubstr("copies of a region must hold the same points"));
  TileSet foreign = shared_set();  // a point that only one of the tiles of its edge holds
  foreign.tiles[0][4].slot = 99;
  EXPECT_THAT(message(format_tile_set(foreign)), HasSubstr("not in exactly those tiles"));
  TileSet twice = shared_set();
  twice.tiles[2][15].position = twice.tiles[2][14].position;
  EXPECT_THAT(message(format_tile_set(twice)), HasSubstr("holds this point twice"));
}

TEST(RegionLayout, NeighbouringTilesSeeTheSameEdgesAndCorners) {
  const std::uint32_t C = 3;
  for (std::uint32_t t = 0; t < tile_count(C); ++t)
    for (std::uint32_t u = 0; u < tile_count(C); ++u) {
      const auto a = tile_colours(C, t), b = tile_colours(C, u);
      if (a[1] == b[0] && a[3] == b[2]) {  // u may stand right of t
        EXPECT_EQ(tile_region(C, t, RegionKind::vertical_edge, 1),
                  tile_region(C, u, RegionKind::vertical_edge, 0));
        EXPECT_EQ(tile_region(C, t, RegionKind::corner, 3), tile_region(C, u, RegionKind::corner, 2));
      }
      if (a[2] == b[0] && a[3] == b[1]) {  // u may stand above t
        EXPECT_EQ(tile_region(C, t, RegionKind::horizontal_edge, 1),
                  tile_region(C, u, RegionKind::horizontal_edge, 0));
      }
    }
}

TEST(TileSet, CompactSetsKeepEveryBit) {
  const TileSet set =
      to_tile_set(random_tied_points(3, 20, {2, 1, 8}, 5, Colouring::apart), "a recipe, with words");
  EXPECT_EQ(set.tile_count(), 35u);
  EXPECT_EQ(set.tiles.size(), 81u);
  EXPECT_TRUE(set.tiles[40].empty());  // all corners of colour 1
  const std::string text = format_tile_set(set);
  EXPECT_THAT(text, StartsWith("capcon-tiles 2\ncolours 3\npoints 20\ncolouring apart\nrecipe a recipe"));
  const TileSet back = parse_tile_set(text, "x");
  EXPECT_EQ(back.colouring, Colouring::apart);
  EXPECT_EQ(format_tile_set(back), text);
}

TEST(TileSet, CompactSetsHoldTheirTilesOnly) {
  const TileSet set = to_tile_set(random_tied_points(2, 16, {0, 0, 16}, 5, Colouring::apart), "a test");
  EXPECT_THAT(message(edited(set, "colouring apart", "colouring free")),
              StartsWith("my.tiles:4: 'colouring apart' should"));
  EXPECT_THAT(message(edited(set, "capcon-tiles 2", "capcon-tiles 1")), StartsWith("my.tiles:4: 'recipe"));
  EXPECT_THAT(message(edited(set, "tile 4", "tile 3")),
              StartsWith("my.tiles:57: 'tile 4' should stand here: a compact set has 7 tiles"));
}

// Version 1 as it was written first, with a shared corner; version 2 beside it.
TEST(TileSet, FrozenBytesOfBothVersions) {
  const std::string one =
      "capcon-tiles 1\ncolours 1\npoints 2\nrecipe by hand\ntile 0\n"
      "4294967295 1 corner 0 1\n2147483648 1073741824 interior 0 0\nchecksum fnv1a64 fa390a0526f9cf1d\n";
  const std::string two =
      "capcon-tiles 2\ncolours 2\npoints 1\ncolouring apart\nrecipe by hand\n"
      "tile 0\n0 5 interior 0 0\ntile 1\n1 5 interior 1 0\ntile 2\n2 5 interior 2 0\n"
      "tile 4\n3 5 interior 4 0\ntile 6\n4 5 interior 6 0\ntile 8\n5 5 interior 8 0\n"
      "tile 9\n6 5 interior 9 0\nchecksum fnv1a64 1132ef1d493aaafe\n";
  const TileSet first = parse_tile_set(one, "one"), second = parse_tile_set(two, "two");
  EXPECT_EQ(first.colouring, Colouring::free);
  EXPECT_EQ(first.tiles[0][1].position, (FixedPoint{2147483648u, 1073741824u}));
  EXPECT_EQ(first.tiles[0][0].kind, RegionKind::corner);
  EXPECT_EQ(second.tiles[9][0].position, (FixedPoint{6, 5}));
  EXPECT_EQ(format_tile_set(first), one);
  EXPECT_EQ(format_tile_set(second), two);
}

// Frozen: sets of format version 1 must stay readable, and the shipped set is what samplers' results rest on.
TEST(ShippedTileSet, IsTheFrozenOne) {
  const TileSet set = shipped_tile_set();
  EXPECT_EQ(set.colours, 2u);
  EXPECT_EQ(set.points_per_tile, 16u);
  EXPECT_EQ(set.tile_count(), 16u);
  EXPECT_EQ(fmt::format("{:016x}", checksum(set)), "30b6841b7d6b2019");
  EXPECT_EQ(format_tile_set(set), read_file(shipped_file("tiles/c2n16.tiles")));
  EXPECT_EQ(shipped_tile_set("c2n64").points_per_tile, 64u);
  EXPECT_EQ(shipped_tile_set("c3n16-compact").tile_count(), 35u);
}

}  // namespace
}  // namespace capcon
