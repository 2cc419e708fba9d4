#include "plot/measure_sheet.h"

#include <gtest/gtest.h>

#include <set>

#include "base/hash.h"

namespace capcon::plot {
namespace {

/// Keeps what is painted.
class Recorder : public Canvas {
 public:
  void polygon(std::span<const glm::dvec2> corners, Colour) override {
    note({corners.begin(), corners.end()});
  }
  void polyline(std::span<const glm::dvec2> points, const Stroke&) override {
    note({points.begin(), points.end()});
  }
  void disc(glm::dvec2 centre, double, Colour) override {
    ++discs;
    note({centre});
  }
  void text(glm::dvec2 at, std::string_view text, const TextStyle&) override {
    texts.emplace(text);
    note({at});
  }
  void image(const Box& box, const Pixels& pixels) override {
    EXPECT_EQ(pixels.colours.size(), std::size_t(pixels.width) * pixels.height);
    note({{box.x, box.y}, {box.right(), box.bottom()}});
    images.push_back(pixels);
  }
  void begin_clip(const Box&) override { clipped = true; }
  void end_clip() override { clipped = false; }

  int discs = 0;
  std::multiset<std::string> texts;
  std::vector<Pixels> images;
  glm::dvec2 low{1e9}, high{-1e9};
  bool clipped = false;

 private:
  void note(const std::vector<glm::dvec2>& points) {
    if (clipped) return;
    for (const glm::dvec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
};

SheetEntry entry(std::size_t n, bool spectrum, const std::string& title) {
  SheetEntry e{title, 1, {}, {}, {}, {}};
  for (std::uint64_t i = 0; i < n; ++i)
    e.points.emplace_back(uniform64(1, n, 2 * i), uniform64(1, n, 2 * i + 1));
  e.measures = measure(e.points);
  if (spectrum) {
    e.spectrum = power_spectrum({e.points}, 10);
    e.radial = radial_spectrum(*e.spectrum);
  }
  return e;
}

TEST(MeasureSheet, ShowsEveryEntryWithinItsPage) {
  for (const std::size_t count : {1, 2, 3, 7}) {
    std::vector<SheetEntry> entries;
    for (std::size_t k = 0; k < count; ++k) entries.push_back(entry(50, true, "set " + std::to_string(k)));
    const MeasureSheet sheet(entries);
    Recorder recorder;
    sheet.draw(recorder);
    EXPECT_EQ(recorder.discs, int(50 * count));
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(recorder.texts.count("set " + std::to_string(k)), 1u);
    EXPECT_EQ(recorder.texts.count("energy"), count);
    EXPECT_EQ(recorder.images.size(), count + 2);  // spectra and the legend's bars
    EXPECT_GE(recorder.low.x, 0);
    EXPECT_GE(recorder.low.y, 0);
    EXPECT_LE(recorder.high.x, sheet.width());
    EXPECT_LE(recorder.high.y, sheet.height());
  }
}

TEST(MeasureSheet, SpectraStandUprightWithoutTheirCentre) {
  SheetEntry e = entry(50, true, "a");
  e.spectrum->power.assign(21 * 21, 0.0);
  e.spectrum->power[std::size_t(15) * 21 + 10] = 4;  // k = (0, 5): above the middle
  e.spectrum->power[std::size_t(10) * 21 + 10] = 50;
  Recorder recorder;
  MeasureSheet({e}).draw(recorder);
  const Pixels& image = recorder.images[0];
  EXPECT_EQ(image.colours[std::size_t(5) * 21 + 10], (Colour{255, 255, 255}));
  EXPECT_EQ(image.colours[std::size_t(10) * 21 + 10], (Colour{0, 0, 0}));
}

TEST(MeasureSheet, DrawsAPartOfManyPointsAndNoMissingSpectrum) {
  Recorder recorder;
  MeasureSheet({entry(16384, false, "many")}).draw(recorder);
  EXPECT_NEAR(recorder.discs, 1024, 150);
  EXPECT_EQ(recorder.texts.count("a part: 0.25 of the side"), 1u);
  EXPECT_EQ(recorder.texts.count("spectrum not computed (--all)"), 1u);
}

}  // namespace
}  // namespace capcon::plot
