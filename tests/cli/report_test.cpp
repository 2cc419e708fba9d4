// capcon report, as its users type it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string scene_in(const Folder& folder) {
  return folder.write(
      "s.pbrt",
      "LookAt 0 -4 3 0 0 0 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
      "Film \"rgb\" \"integer xresolution\" 12 \"integer yresolution\" 8\nWorldBegin\n"
      "Shape \"disk\" \"float radius\" 5\nTranslate 0 0 0.5\nShape \"sphere\" \"float radius\" 0.5\n");
}

std::string study(const std::string& scene, const std::string& folder, const std::string& more) {
  return "study ambient-occlusion " + scene +
         " --samplers sobol-owen,capcon-domain "
         "--samples 4,16 --height 16 --reference-samples 256 --radius 1 --no-close-ups --quiet --device "
         "reference -o " +
         folder + " " + more;
}

TEST(ReportVerb, MakesAPageAnewAndLaysStudiesOverEachOther) {
  const Folder folder;
  const std::string scene = scene_in(folder);
  const std::string a = folder / "a", b = folder / "b", c = folder / "c";
  ASSERT_EQ(run(study(scene, a, "--seeds 2 --width 24")).exit_code, 0);
  ASSERT_EQ(run(study(scene, b, "--seeds 3 --width 24")).exit_code, 0);
  ASSERT_EQ(run(study(scene, c, "--seeds 2 --width 20")).exit_code, 0);
  const std::string before = contents(a + "/report.html");
  fs::remove(a + "/report.html");
  const Outcome one = run("report " + a);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(contents(a + "/report.html"), before);
  EXPECT_NE(one.err.find("The report is "), std::string::npos);
  EXPECT_FALSE(one.out.empty());

  const std::string page = folder / "both.html";
  const Outcome both = run("report --json --quiet --label first,second -o " + page + " " + a + " " + b);
  ASSERT_EQ(both.exit_code, 0) << both.err;
  const json figures = json::parse(both.out);
  EXPECT_EQ(figures.at("beside").at(0).at("label"), "second");
  EXPECT_EQ(figures.at("beside").at(0).at("same_errors"), true);
  EXPECT_EQ(figures.at("seeds"), 2);
  EXPECT_NE(contents(page).find("sobol-owen @ second"), std::string::npos);

  const auto refused = [](const std::string& words, const std::string& why) {
    const Outcome outcome = run("report " + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  const std::string other = folder / "other.html";
  refused("-o " + other + " " + a + " " + c, "width is 24 in one and 20 in the other");
  refused(a + " " + b, "with -o");
  refused(folder / "nothing", "there is no study.json");
  refused("-o " + other + " --label x " + a + " " + b, "1 labels for 2 studies");
  refused("-o " + other + " --samplers halton " + a + " " + b, "halton was not measured");
  refused("--label x " + a, "there is one");
  EXPECT_FALSE(fs::exists(other));
}

}  // namespace
}  // namespace capcon::testing
