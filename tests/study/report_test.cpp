#include "study/report.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "base/error.h"
#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/chart.h"
#include "study/html.h"
#include "study/kept_study.h"
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

/// The page without its scripts and the data in them; `data` receives what is in those that are JSON.
std::string without_scripts(const std::string& html, std::vector<std::string>* data = nullptr) {
  std::string text;
  for (std::size_t begin = 0; begin < html.size();) {
    const std::size_t script = std::min(html.find("<script", begin), html.size());
    text += html.substr(begin, script - begin);
    const std::size_t end = html.find("</script>", script);
    if (data && script < html.size()) {
      const std::size_t content = html.find('>', script) + 1;
      if (html.substr(script, content - script).find("application/json") != std::string::npos)
        data->push_back(html.substr(content, end - content));
    }
    begin = end == std::string::npos ? html.size() : end + 9;
  }
  return text;
}

/// What a table hands out as CSV, line by line.
std::vector<std::string> csv_lines(const std::string& html, const std::string& file) {
  const std::size_t link = html.find("download=\"" + file + "\"");
  if (link == std::string::npos) return {};
  const std::size_t begin = html.find("utf-8,", link) + 6;
  std::string text;
  for (std::size_t i = begin; html[i] != '"'; ++i) {
    if (html[i] == '%') {
      text += static_cast<char>(std::stoi(html.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      text += html[i];
    }
  }
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// The first tag that does not close what is open; empty when all is in order. Void elements stand alone.
std::string unbalanced(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::string tag = html.substr(at + 1, html.find('>', at) - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (tag.back() == '/' || name == "meta" || name == "img" || name == "br" || name == "!DOCTYPE") continue;
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
  // Nothing is loaded, and without scripts the page is whole.
  std::vector<std::string> data;
  const std::string still = without_scripts(html, &data);
  for (const char* outside :
       {"http:", "https:", "<link", "@import", "url(", "src=\"//", "onload=", "<script"}) {
    EXPECT_EQ(still.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);  // and browsers see to it
  for (std::size_t at = still.find("src="); at != std::string::npos; at = still.find("src=", at + 1)) {
    EXPECT_TRUE(still.substr(at, 27) == "src=\"data:image/png;base64," ||
                still.substr(at, 11) == "src 'none';")
        << still.substr(at, 27);
  }
  EXPECT_EQ(without_pictures(still).find("nan"), std::string::npos);
  EXPECT_NE(still.find("<svg class=\"chart\""), std::string::npos);
  // What charts, viewer and downloads hold is JSON.
  ASSERT_GE(data.size(), 6u);
  for (const std::string& text : data) EXPECT_TRUE(nlohmann::json::accept(text)) << text.substr(0, 200);
  EXPECT_EQ(nlohmann::json::parse(data.back()), nlohmann::json::parse(read_file(folder / "study.json")));
  EXPECT_EQ(data.front().find('<'), std::string::npos);
  EXPECT_EQ(html.find("fake <scene>"), std::string::npos);
  EXPECT_NE(html.find("fake &lt;scene&gt;"), std::string::npos);
  EXPECT_NE(html.find("none &lt;1 &amp; 2&gt;"), std::string::npos);
  EXPECT_NE(html.find("capcon needs"), std::string::npos);
  EXPECT_NE(html.find(s.command), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(read_file(folder / "study.json"));
  EXPECT_EQ(json["curves"].size(), 4u);
  EXPECT_EQ(json["ratios"].size(), 2u * 3 * s.samples.size());
  EXPECT_TRUE(std::filesystem::exists(folder / "reference.exr"));
  // Tables hand out what they show, and more digits of it.
  const auto runs = csv_lines(still, "runs.csv"), figures = csv_lines(still, "figures.csv");
  EXPECT_EQ(runs.size(), 1 + report.result.records.size());
  ASSERT_EQ(figures.size(), 1 + s.samplers.size() * s.samples.size());
  const Cell& cell = report.figures.curves[0].cells[0];
  EXPECT_EQ(
      figures[1].find(fmt::format("random,1,yes,{},{},{},", cell.mse.value, cell.mse.low, cell.mse.high)), 0u)
      << figures[1];
  EXPECT_EQ(csv_lines(still, "ratios-sobol-xor.csv").size(), 1 + 3 * s.samples.size());
  EXPECT_EQ(csv_lines(still, "slopes.csv").size(), 1 + 2 * s.samplers.size());
}

TEST(Report, StaysSmallWithManySamplers) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.close_ups = true;
  s.width = 98, s.height = 61;
  for (int i = 0; i < 12; ++i) s.samplers.push_back(fmt::format("another-{}", i));
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  study_report(s, fake_device(), options);
  EXPECT_LT(std::filesystem::file_size(folder / "report.html"), 3'000'000u);
}

TEST(Report, IsMadeAgainFromWhatWasKept) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.close_ups = true;
  s.samples = {4, 16};
  s.seeds = 3;
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  Explanation explanation;
  explanation.rows = {{"textures", "none", false, "nothing read"}};
  explanation.repeats = 3;
  study_report(s, fake_device(), options, explanation);
  const KeptStudy kept = read_kept_study(folder);
  EXPECT_EQ(html_report(kept, make_figures(kept)), read_file(folder / "report.html"));
  // Without its pictures it is a report without close-ups; without its runs there is none.
  std::filesystem::remove(folder / "close-ups/picture.exr");
  const std::string without = html_report(kept, make_figures(kept));
  EXPECT_EQ(without.find("id=\"close-ups\""), std::string::npos);
  EXPECT_NE(without.find("left out: nothing read"), std::string::npos);
  // What others have written is checked.
  const auto study = nlohmann::json::parse(read_file(folder / "study.json"));
  for (const auto& [place, value] : {std::pair<const char*, nlohmann::json>{"/settings/seeds", 4294967295u},
                                     {"/settings/samples", {0, 4}},
                                     {"/settings/samplers", {"halton"}},
                                     {"/settings/width", -1},
                                     {"/device/name", 7},
                                     {"/device", "gpu"},
                                     {"/reference/error", "none"},
                                     {"/version", nullptr}}) {
    nlohmann::json broken = study;
    broken[nlohmann::json::json_pointer(place)] = value;
    write_file(folder / "study.json", broken.dump());
    EXPECT_THROW(read_kept_study(folder), InputError) << place;
  }
  write_file(folder / "study.json", study.dump());
  std::filesystem::remove(folder / "runs.jsonl");
  EXPECT_THROW(read_kept_study(folder), InputError);
  write_file(folder / "study.json", "{}");
  EXPECT_THROW(read_kept_study(folder), InputError);
  std::filesystem::remove(folder / "study.json");
  EXPECT_THROW(read_kept_study(folder), InputError);
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
  const std::string html = without_pictures(without_scripts(read_file(folder / "report.html")));
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

TEST(Chart, WideIntervalsDoNotFlattenIt) {
  Chart chart{"c", "t", "d", "x", "y", LogAxis::Style::counts, LogAxis::Style::decades, false, {}};
  chart.lines.push_back(
      {"a",
       0,
       false,
       {{{1, NAN, NAN}, {1, 1e-6, 1e6}, true, ""}, {{2, NAN, NAN}, {0.1, 0.09, 0.11}, true, ""}},
       {}});
  const std::string svg = svg_chart(chart);
  const std::regex bar("class=\"bar\" x1=\"[0-9.]+\" x2=\"[0-9.]+\" y1=\"([0-9.]+)\" y2=\"([0-9.]+)\"");
  std::smatch first;
  ASSERT_TRUE(std::regex_search(svg, first, bar));
  EXPECT_NEAR(std::stod(first[1]), 370, 0.1);  // from the bottom of the chart
  EXPECT_NEAR(std::stod(first[2]), 14, 0.1);   // to its top
  const std::regex mark("<circle cx=\"[0-9.]+\" cy=\"([0-9.]+)\"");
  std::vector<double> places;
  for (std::sregex_iterator i(svg.begin(), svg.end(), mark), end; i != end; ++i)
    places.push_back(std::stod((*i)[1]));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_GT(places[1] - places[0], 100);  // a decade of values is well seen
}

TEST(Html, CsvQuotesWhatMustBe) {
  Csv csv("a,b,c");
  csv.add("x,\"y\"").add(0.1).add(NAN).end_row();
  csv.add("z").add(1e-300).add("").end_row();
  EXPECT_EQ(csv.text(), "a,b,c\n\"x,\"\"y\"\"\",0.1,\nz,1e-300,\n");
  EXPECT_EQ(csv_lines(csv.link("f.csv", "what"), "f.csv").at(1), "\"x,\"\"y\"\"\",0.1,");
  EXPECT_EQ(data_script("id=\"d\"", "{\"a\":\"</script>\"}"),
            "<script id=\"d\">{\"a\":\"\\u003c/script>\"}</script>");
}

TEST(Html, EscapesAndEncodes) {
  EXPECT_EQ(escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  const std::string image = embedded_image(Image(2, 1, 1), 1, "a \"b\"");
  EXPECT_NE(image.find("base64,iVBORw0KGgo"), std::string::npos);  // a PNG's signature
  EXPECT_NE(image.find("a &quot;b&quot;"), std::string::npos);
}

}  // namespace
}  // namespace capcon
