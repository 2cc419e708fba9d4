#include "plot/tile_sheet.h"

#include <gtest/gtest.h>

#include "plot/raster_canvas.h"
#include "plot/svg_canvas.h"
#include "plot/tiling_panel.h"

namespace capcon::plot {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// 16 tiles of 16 points: a disc a point, 25 corners of which those of colour 1 are blue, a line a border.
TEST(TilingPanel, DrawsPointsCornersAndBorders) {
  const TileSet set = shipped_tile_set();
  SvgCanvas canvas(400, 400, {});
  draw_tiling(canvas, {0, 0, 400, 400}, set, {4, 0, 1});
  EXPECT_EQ(count(canvas.str(), "<circle"), 256u + 25);
  SvgCanvas some(400, 400, {});
  draw_tiling(some, {0, 0, 400, 400}, set, {4, 3, 1});
  EXPECT_EQ(count(some.str(), "<circle"), 48u + 25);
}

TEST(TileSheet, SaysWhatTheReportSays) {
  TileReportOptions options;
  options.tilings = 2;
  options.prefix_tilings = 1;
  options.untiled_sets = 1;
  options.capacity = 16;
  const TileSheetData data = tile_sheet_data("a set", shipped_tile_set(), options);
  ASSERT_EQ(data.sizes.size(), 3u);
  EXPECT_EQ(data.sizes[2].tiles, 256u);
  EXPECT_EQ(data.report.prefixes.size(), 16u);
  EXPECT_EQ(data.report.prefixes[4].ranks, 5u);
  SvgCanvas canvas(TileSheet::kWidth, TileSheet::kHeight, {});
  const TileSheet sheet(data);
  sheet.draw(canvas);
  const std::string page = canvas.str();
  EXPECT_NE(page.find("a set: 16 tiles of 16 points"), std::string::npos);
  EXPECT_NE(page.find("16 x 16 tiles, 4096 points"), std::string::npos);
  EXPECT_NE(page.find("capcon tiles make --colours 2 --points 16 --seed 1"), std::string::npos);
  EXPECT_EQ(count(page, "<image"), 1u);
  char energy[16];
  std::snprintf(energy, sizeof energy, "%.4f", data.sizes[0].energy);
  EXPECT_NE(page.find(energy), std::string::npos);
}

}  // namespace
}  // namespace capcon::plot
