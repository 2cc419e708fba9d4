#include "plot/canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/error.h"
#include "base/file.h"
#include "plot/coverage.h"
#include "plot/glyphs.h"
#include "plot/palette.h"
#include "plot/picture_file.h"
#include "plot/raster_canvas.h"
#include "plot/svg_canvas.h"

namespace capcon::plot {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

double total(const Coverage& c) {
  return std::accumulate(c.share.begin(), c.share.end(), 0.0);
}

double at(const Coverage& c, int x, int y) {
  return c.share.at(std::size_t(y - c.y) * c.width + (x - c.x));
}

TEST(Coverage, PolygonsCoverTheirArea) {
  const PixelBounds bounds{0, 0, 20, 20};
  const std::vector<glm::dvec2> rectangle{{2.25, 3.5}, {5.5, 3.5}, {5.5, 6.75}, {2.25, 6.75}};
  const Coverage c = cover_polygon(rectangle, bounds);
  EXPECT_NEAR(total(c), 3.25 * 3.25, 1e-5);
  EXPECT_NEAR(at(c, 3, 4), 1, 1e-6);
  EXPECT_NEAR(at(c, 2, 3), 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(at(c, 5, 6), 0.5 * 0.75, 1e-6);
  // Triangles by Heron, whichever way they turn; a pixel cut by one edge.
  for (const auto& corners : {std::vector<glm::dvec2>{{1.1, 1.3}, {17.2, 4.9}, {6.4, 18.8}},
                              std::vector<glm::dvec2>{{6.4, 18.8}, {17.2, 4.9}, {1.1, 1.3}}}) {
    const glm::dvec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
    EXPECT_NEAR(total(cover_polygon(corners, bounds)), std::abs(a.x * b.y - a.y * b.x) / 2, 1e-4);
  }
  const std::vector<glm::dvec2> half{{0, 0}, {20, 0}, {0, 20}};
  EXPECT_NEAR(at(cover_polygon(half, bounds), 10, 9), 0.5, 1e-6);
}

TEST(Coverage, PolygonsAreCutAtTheBounds) {
  // A large rhombus about the centre: the part inside a 10 x 10 window at its middle and at its tip.
  const std::vector<glm::dvec2> rhombus{{50, 0}, {100, 50}, {50, 100}, {0, 50}};
  EXPECT_NEAR(total(cover_polygon(rhombus, {45, 45, 55, 55})), 100, 1e-4);
  EXPECT_NEAR(total(cover_polygon(rhombus, {90, 45, 110, 55})), 100 - 2 * 12.5, 1e-4);
  EXPECT_NEAR(total(cover_polygon(rhombus, {-10, 45, 10, 55})), 100 - 2 * 12.5, 1e-4);
  EXPECT_NEAR(total(cover_polygon(rhombus, {0, 0, 100, 100})), 5000, 1e-2);
  EXPECT_TRUE(cover_polygon(rhombus, {200, 0, 210, 10}).empty());
}

TEST(Coverage, LinesCoverOnceWhereTheyCross) {
  const std::vector<std::vector<glm::dvec2>> lines{
      {{2, 10}, {18, 10}}, {{10, 2}, {10, 18}}, {{2, 10}, {18, 10}}};
  const Coverage c = cover_lines(lines, 4, {0, 0, 20, 20});
  EXPECT_EQ(at(c, 10, 10), 1);
  EXPECT_EQ(at(c, 3, 3), 0);
  // Two bars of 16 x 4 with round ends less their square in the middle.
  EXPECT_NEAR(total(c), 2 * (16 * 4 + 4 * M_PI) - 16, 1.0);
  const std::vector<std::vector<glm::dvec2>> hair{{{2, 10.5}, {18, 10.5}}};
  EXPECT_NEAR(at(cover_lines(hair, 0.25, {0, 0, 20, 20}), 10, 10), 0.25, 1e-6);
}

TEST(RasterCanvas, ADiscHasItsArea) {
  RasterCanvas canvas(20, 20, {0, 0, 0}, 2);
  canvas.disc({10, 10}, 6, {200, 0, 0});
  double sum = 0;
  for (const Colour& c : canvas.pixels().colours) sum += c.r / 200.0;
  EXPECT_NEAR(sum, M_PI * 12 * 12, 2);
}

TEST(RasterCanvas, ClipsAndDashes) {
  RasterCanvas canvas(40, 10, {255, 255, 255});
  canvas.begin_clip({5, 0, 10, 10});
  canvas.rectangle({0, 0, 40, 10}, {0, 0, 0});
  canvas.end_clip();
  int black = 0;
  for (const Colour& c : canvas.pixels().colours) black += c == Colour{0, 0, 0};
  EXPECT_EQ(black, 100);
  RasterCanvas dashed(40, 9, {255, 255, 255});
  dashed.line({0, 4.5}, {40, 4.5}, {{0, 0, 0}, 1, 5});
  const auto value = [&](int x) { return int(dashed.pixels().colours[4 * 40 + x].r); };
  EXPECT_EQ(value(2), 0);
  EXPECT_EQ(value(7), 255);
  EXPECT_EQ(value(12), 0);
  EXPECT_EQ(value(37), 255);
}

TEST(RasterCanvas, ImagesKeepTheirPixelsOrTheirMean) {
  const Pixels board{2, 2, {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, {0, 0, 0}}};
  RasterCanvas large(8, 8, {9, 9, 9});
  large.image({0, 0, 8, 8}, board);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(large.pixels().colours[y * 8 + x].r, (x < 4) == (y < 4) ? 0 : 255);
  }
  RasterCanvas small(1, 1, {9, 9, 9});
  small.image({0, 0, 1, 1}, board);
  EXPECT_EQ(small.pixels().colours[0].g, 127);
}

TEST(Glyphs, EveryCharacterIsItsOwn) {
  std::vector<std::vector<std::vector<glm::dvec2>>> seen;
  for (char c = 33; c < 127; ++c) {
    const auto strokes = text_strokes(std::string(1, c));
    ASSERT_FALSE(strokes.empty()) << c;
    for (const auto& stroke : strokes) {
      for (const glm::dvec2& p : stroke) {
        EXPECT_TRUE(p.x >= -0.001 && p.x <= 0.97 && p.y >= -0.25 && p.y <= 0.85) << c;
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), strokes), 0) << c;
    seen.push_back(strokes);
  }
}

TEST(Glyphs, TextAdvances) {
  EXPECT_DOUBLE_EQ(text_width("11"), text_width("08"));  // figures stand in columns
  EXPECT_GT(text_width("mm"), text_width("ii"));
  EXPECT_EQ(text_width(""), 0);
  EXPECT_EQ(text_strokes("\u221a").size(), 3u);
  EXPECT_EQ(text_strokes("\u00e9").size(), text_strokes("\u00fc").size());  // one box each
  EXPECT_GT(text_strokes("ab").back().back().x, text_width("a"));
}

TEST(SvgCanvas, IsWellFormed) {
  SvgCanvas canvas(100, 50, kGround);
  canvas.begin_clip({0, 0, 10, 10});
  canvas.disc({1.239, -0.001}, 2, {1, 2, 255});
  canvas.end_clip();
  canvas.text({1, 2}, "a<b & \"c\">", {.colour = kInk, .anchor = Anchor::kEnd});
  canvas.image({0, 0, 5, 5}, {1, 1, {{1, 2, 3}}});
  const std::string svg = canvas.str();
  EXPECT_THAT(svg, StartsWith("<svg xmlns="));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"1.24\" cy=\"0\" r=\"2\" fill=\"#0102ff\"/>"));
  EXPECT_THAT(svg, HasSubstr(">a&lt;b &amp; \"c\"&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr("href=\"data:image/png;base64,iVBORw0KGgo"));  // PNG's signature
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(PictureFile, NamesSayTheKind) {
  const auto folder = std::filesystem::temp_directory_path() / ("capcon_plot_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  EXPECT_THROW(check_picture_name((folder / "a.jpg").string()), InputError);
  EXPECT_THROW(check_picture_name((folder / "none" / "a.png").string()), Failure);
  const auto draw = [](Canvas& canvas) { canvas.rectangle({0, 0, 1, 1}, {1, 2, 3}); };
  for (const char* name : {"a.svg", "a.png"}) {
    const std::string path = (folder / name).string();
    check_picture_name(path);
    EXPECT_FALSE(std::filesystem::exists(path));
    write_picture(path, 4, 4, draw);
    EXPECT_THAT(read_file(path), StartsWith(name[2] == 's' ? "<svg" : "\x89PNG"));
  }
  EXPECT_THROW(write_picture((folder / "b.png").string(), 1e5, 1e5, draw), Failure);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
  std::filesystem::remove_all(folder);
}

TEST(Palette, IsNeutralInTheMiddleAndTellsTheSides) {
  const Colour middle = diverging(0), low = diverging(-0.5), high = diverging(0.5);
  EXPECT_GT(std::min({middle.r, middle.g, middle.b}), 235);
  EXPECT_GT(low.b, low.r + 50);
  EXPECT_GT(high.r, high.b + 50);
  EXPECT_EQ(diverging(7), diverging(1));
}

}  // namespace
}  // namespace capcon::plot
