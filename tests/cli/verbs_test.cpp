#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

std::string small_scene(const Folder& folder) {
  return folder.write("s.pbrt",
                      "Camera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 24\nWorldBegin\n"
                      "Translate 0 0 4\nShape \"sphere\"\nShape \"disk\" \"float radius\" 5 \"float height\" 1\n");
}

TEST(Verbs, EveryHelpHasExamplesOrOptions) {
  for (const char* verb : {"", "render", "points", "measure", "tiles", "tiles make", "tiles verify", "tiles show", "tiles sheet", "tiles parts", "partition", "ensembles", "ensembles make", "ensembles show", "compare", "report", "info",
                           "study", "study ambient-occlusion", "study direct", "study splitting", "stability"}) {
    const Outcome help = run(std::string(verb) + " --help");
    EXPECT_EQ(help.exit_code, 0) << verb;
    EXPECT_GT(help.out.size(), 100u) << verb;
    EXPECT_EQ(help.err, "") << verb;
  }
  EXPECT_EQ(run("--version").out.rfind("capcon ", 0), 0u);
}

TEST(Verbs, RenderTwiceGivesTheSameBytes) {
  const Folder folder;
  const std::string words = "render " + small_scene(folder) + " --radius 2 --samples 8 --seed 7 --quiet --device lavapipe -o ";
  ASSERT_EQ(run(words + (folder / "a.png")).exit_code, 0);
  ASSERT_EQ(run(words + (folder / "b.png")).exit_code, 0);
  EXPECT_EQ(contents(folder / "a.png"), contents(folder / "b.png"));
  ASSERT_EQ(run(words + (folder / "a.exr")).exit_code, 0);
  ASSERT_EQ(run(words + (folder / "b.exr")).exit_code, 0);
  const json same = json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / "b.exr")).out);
  EXPECT_EQ(same.at("mse"), 0);
  EXPECT_EQ(same.at("max_difference"), 0);
  EXPECT_EQ(same.at("flip"), 0);
  EXPECT_EQ(same.at("hdr_flip").at("value"), 0);
}

TEST(Verbs, DeviceAndReferenceAgree) {
  const Folder folder;
  const std::string words = "render " + small_scene(folder) + " --radius 2 --samples 16 --quiet ";
  ASSERT_EQ(run(words + "--device lavapipe --validate -o " + (folder / "a.exr")).exit_code, 0);
  ASSERT_EQ(run(words + "--device reference -o " + (folder / "b.exr")).exit_code, 0);
  const json difference = json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / "b.exr")).out);
  EXPECT_LE(difference.at("beyond").get<double>(), 2.0 / (32 * 24));
  EXPECT_LT(difference.at("flip").get<double>(), 0.01);
}

TEST(Verbs, RenderReportsItsStages) {
  const Folder folder;
  const Outcome render = run("render " + small_scene(folder) + " --samples 4 --json -o " + (folder / "a.exr"));
  ASSERT_EQ(render.exit_code, 0) << render.err;
  const json report = json::parse(render.out);
  EXPECT_EQ(report.at("rays"), 32 * 24 * 4);
  for (const char* stage : {"read", "build", "upload", "compile", "points", "occlusion", "resolve", "write"}) {
    EXPECT_GE(report.at("timings").at("wall").at(stage).get<double>(), 0) << stage;
  }
  for (const char* stage : {"primary", "occlusion"}) EXPECT_GT(report.at("timings").at("device").at(stage).get<double>(), 0) << stage;
}

TEST(Verbs, PointsAndMeasure) {
  const Folder folder;
  const std::string words = "points ccvt -n 64 --capacity 64 --seed 3 --quiet -o ";
  ASSERT_EQ(run(words + (folder / "a.txt")).exit_code, 0);
  ASSERT_EQ(run(words + (folder / "b.txt")).exit_code, 0);
  EXPECT_EQ(contents(folder / "a.txt"), contents(folder / "b.txt"));
  const Outcome measured = run("measure --json " + (folder / "a.txt"));
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  EXPECT_NE(measured.out.find("\"energy\""), std::string::npos);
  EXPECT_NO_THROW(json::parse(measured.out));
}

TEST(Verbs, TilesShowDraws) {
  const Folder folder;
  ASSERT_EQ(run("tiles show shipped --width 4 -o " + (folder / "t.svg")).exit_code, 0);
  EXPECT_NE(contents(folder / "t.svg").find("<svg"), std::string::npos);
  ASSERT_EQ(run("tiles show shipped --width 4 -o " + (folder / "t.png")).exit_code, 0);
  EXPECT_EQ(contents(folder / "t.png").substr(1, 3), "PNG");
}

// The whole study, small: its files are there, its page stands alone, and running it again adds nothing.
TEST(Verbs, StudyWritesItsReport) {
  const Folder folder;
  const std::string words = "study ambient-occlusion " + small_scene(folder) +
                            " --radius 2 --samples 1,4 --seeds 8 --reference-samples 64 --quiet --device lavapipe -o " + (folder / "r");
  const Outcome first = run(words);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  for (const char* sampler : {"random", "jittered", "sobol-xor", "sobol-owen", "ccvt", "capcon"}) {
    EXPECT_NE(first.out.find(sampler), std::string::npos) << sampler;
  }
  const std::string page = contents(folder / "r/report.html");
  EXPECT_NE(page.find("capcon"), std::string::npos);
  EXPECT_LT(page.size(), 3u << 20);
  const std::string runs = contents(folder / "r/runs.jsonl");
  EXPECT_GE(std::count(runs.begin(), runs.end(), '\n'), 6 * 2 * 8);
  ASSERT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(contents(folder / "r/runs.jsonl"), runs);
}

}  // namespace
}  // namespace capcon::testing
