#include "study/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/chart.h"
#include "study/html.h"
#include "study/study.h"

namespace capcon {
namespace {

/// The page without what is inside its pictures.
std::string without_pictures(const std::string& html) {
  std::string text;
  for (std::size_t begin = 0; begin < html.size();) {
    const std::size_t picture = std::min(html.find("base64,", begin), html.size());
    text += html.substr(begin, picture - begin);
    begin = std::min(html.find('"', picture), html.size());
  }
  return text;
}

/// The first tag that does not close what is open; empty when all is in order. Void elements stand alone.
std::string unbalanced(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::string tag = html.substr(at + 1, html.find('>', at) - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (tag.back() == '/' || name == "meta" || name == "img" || name == "!DOCTYPE") continue;
    if (name[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return "<" + name + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + ">";
}

TEST(Report, IsOneCompletePage) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.close_ups = true;
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  const StudyReport report = study_report(s, fake_device(), options);
  const std::string html = read_file(folder / "report.html");
  EXPECT_LT(html.size(), 3u << 20);
  EXPECT_EQ(report.page, folder / "report.html");
  for (const std::string& sampler : s.samplers) {
    EXPECT_NE(html.find(">" + sampler + "<"), std::string::npos) << sampler;
  }
  // Nothing is loaded and nothing runs.
  for (const char* outside :
       {"http:", "https:", "<script", "<link", "@import", "url(", "src=\"//", "onload="}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
  for (std::size_t at = html.find("src="); at != std::string::npos; at = html.find("src=", at + 1)) {
    EXPECT_EQ(html.substr(at, 27), "src=\"data:image/png;base64,");
  }
  EXPECT_EQ(without_pictures(html).find("nan"), std::string::npos);
  EXPECT_EQ(html.find("fake <scene>"), std::string::npos);
  EXPECT_NE(html.find("fake &lt;scene&gt;"), std::string::npos);
  EXPECT_NE(html.find("none &lt;1 &amp; 2&gt;"), std::string::npos);
  EXPECT_NE(html.find("capcon needs"), std::string::npos);
  EXPECT_NE(html.find(s.command), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(read_file(folder / "study.json"));
  EXPECT_EQ(json["curves"].size(), 4u);
  EXPECT_EQ(json["ratios"].size(), 2u * 3 * s.samples.size());
  EXPECT_TRUE(std::filesystem::exists(folder / "reference.exr"));
}

TEST(Report, ItsTagsAreBalanced) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.seeds = 1;
  s.samples = {1, 2};
  s.samplers = {"capcon", "a-new-one"};  // no baseline, no interval, no slope
  s.radius = std::numeric_limits<double>::infinity();
  s.close_ups = true;
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  study_report(s, fake_device(), options);
  const std::string html = without_pictures(read_file(folder / "report.html"));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(unbalanced("<p><b></p></b>"), "</p>");
}

TEST(CloseUps, FindTheRegionThatErrsMost) {
  Image errors(40, 30, 1);
  for (int y = 12; y < 20; ++y) {
    for (int x = 20; x < 30; ++x) errors.at(x, y, 0) = 1;
  }
  const Region region = worst_region(errors, 10, 8);
  EXPECT_EQ(region.x, 20);
  EXPECT_EQ(region.y, 12);
  const Image part = crop(errors, region);
  EXPECT_EQ(part.width, 10);
  EXPECT_EQ(part.height, 8);
  for (const float v : part.pixels) EXPECT_EQ(v, 1);
}

TEST(LogAxis, PlacesAndTicks) {
  const LogAxis axis(1, 256, 0, 100, LogAxis::Style::counts);
  EXPECT_EQ(axis.ticks().size(), 9u);
  EXPECT_NEAR(axis.place(16), 50, 1e-9);
  const LogAxis decades(1e-4, 1e-1, 0, 300, LogAxis::Style::decades);
  int labels = 0;
  for (const auto& tick : decades.ticks()) labels += tick.label.empty() ? 0 : 1;
  EXPECT_EQ(labels, 4);
  EXPECT_EQ(decades.ticks().size(),
            28u + 1);  // 1e-4 ... 1e-1 in steps of mantissas, and one beyond the margin
}

TEST(Chart, NamesStandApartAndInside) {
  Chart chart{"c", "t", "d", "x", "y", LogAxis::Style::counts, LogAxis::Style::decades, false, {}};
  for (int i = 0; i < 6; ++i) {
    chart.lines.push_back(
        {"line" + std::to_string(i),
         i,
         false,
         {{{1, 1, 1}, {1, 1, 1}, true, ""}, {{2, 2, 2}, {0.5 + i * 1e-4, 0.5, 0.6}, true, ""}},
         {}});
  }
  const std::string svg = svg_chart(chart);
  const std::regex name("class=\"name\" x=\"[0-9.]+\" y=\"([0-9.]+)\"");
  std::vector<double> places;
  for (std::sregex_iterator i(svg.begin(), svg.end(), name), end; i != end; ++i)
    places.push_back(std::stod((*i)[1]));
  ASSERT_EQ(places.size(), 6u);
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GE(places[i] - places[i - 1], 14.8);
  EXPECT_LE(places.back(), 420);
  EXPECT_GE(places.front(), 0);
}

TEST(Html, EscapesAndEncodes) {
  EXPECT_EQ(escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  const std::string image = embedded_image(Image(2, 1, 1), 1, "a \"b\"");
  EXPECT_NE(image.find("base64,iVBORw0KGgo"), std::string::npos);  // a PNG's signature
  EXPECT_NE(image.find("a &quot;b&quot;"), std::string::npos);
}

}  // namespace
}  // namespace capcon
