#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

std::string triangle_scene(const Folder& folder) {
  return folder.write(
      "s.pbrt",
      "Camera \"perspective\" \"float fov\" 40\nWorldBegin\nTranslate 0 0 4\n"
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 0 1 0] \"integer indices\" [0 1 2]\n"
      "ObjectBegin \"o\"\nShape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 -1 0 2 0] \"integer indices\" [0 "
      "1 2]\n"
      "ObjectEnd\nScale 0.6 -0.6 0.7\nObjectInstance \"o\"\nTranslate 0.2 0.1 -0.4\nObjectInstance \"o\"\n");
}

// The file may grow to 17,000 blocks of 512 bytes: the first band of 1398 rows fits, the second does not.
TEST(Render, AFullDiskLosesNothing) {
  const Folder folder;
  const std::string words =
      "render " + triangle_scene(folder) + " --width 1500 --height 1500 --samples 1 --device lavapipe -o ";
  ASSERT_EQ(run(words + (folder / "straight.exr")).exit_code, 0);
  const Outcome full = run(words + (folder / "a.exr"), "ulimit -f 17000; trap '' XFSZ; ");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("the rows until here are kept"), std::string::npos) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
  const Outcome rest = run(words + (folder / "a.exr"));
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_NE(rest.err.find("going on from 1398 of 1500 rows"), std::string::npos) << rest.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr.partial"));
  const json same =
      json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / "straight.exr")).out);
  EXPECT_EQ(same.at("max_difference"), 0);
}

TEST(Render, ProfileHasARowAStage) {
  const Folder folder;
  const Outcome render =
      run("render " + triangle_scene(folder) + " --samples 4 --profile -o " + (folder / "a.exr"));
  ASSERT_EQ(render.exit_code, 0) << render.err;
  for (const char* stage : {"read", "build", "upload", "compile", "points", "primary", "shading", "occlusion",
                            "resolve", "write", "whole"}) {
    EXPECT_NE(render.err.find(std::string("\n") + stage + " "), std::string::npos) << stage << "\n"
                                                                                   << render.err;
  }
  EXPECT_NE(render.err.find("materials and lights, their tables: left out"), std::string::npos);
}

TEST(Render, ExplainComparesWithEverythingKept) {
  const Folder folder;
  const std::string scene = triangle_scene(folder);
  const Outcome text = run("render " + scene + " --samples 4 --width 64 --height 48 --explain");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("same, bit by bit"), std::string::npos) << text.out;
  const Outcome words = run("render " + scene + " --samples 4 --width 64 --height 48 --explain --json");
  const json report = json::parse(words.out);
  EXPECT_TRUE(report.at("identical").get<bool>());
  EXPECT_EQ(report.at("features").size(), 9u);
  EXPECT_GT(report.at("everything").at("compile_seconds").get<double>(), 0);
  EXPECT_EQ(run("render " + scene + " --explain --device reference").exit_code, 2);
}

TEST(Render, LevelsAndEverythingKeptGiveTheSameImage) {
  const Folder folder;
  const std::string words =
      "render " + triangle_scene(folder) + " --radius 2 --samples 16 --quiet --device lavapipe ";
  ASSERT_EQ(run(words + "--instancing flat -o " + (folder / "flat.exr")).exit_code, 0);
  ASSERT_EQ(run(words + "--instancing two-level -o " + (folder / "two.exr")).exit_code, 0);
  ASSERT_EQ(run(words + "--keep-everything -o " + (folder / "all.exr")).exit_code, 0);
  const auto difference = [&](const char* other) {
    return json::parse(run("compare --json " + (folder / other) + " " + (folder / "flat.exr")).out);
  };
  EXPECT_EQ(difference("all.exr").at("max_difference"), 0);
  EXPECT_LE(difference("two.exr").at("beyond").get<double>(), 0.001);
}

TEST(Render, BadWordsAreUsageErrors) {
  const Folder folder;
  const std::string scene = triangle_scene(folder);
  EXPECT_EQ(run("render " + scene).exit_code, 2);
  EXPECT_EQ(run("render " + scene + " --instancing three-level -o " + (folder / "a.exr")).exit_code, 2);
  EXPECT_EQ(run("render " + scene + " --width 20000 -o " + (folder / "a.exr")).exit_code, 2);
  const Outcome nothing = run("render " + scene + " --radius 0 -o " + (folder / "a.exr"));
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.err, "capcon: --radius: 0 is not a number above 0; see `capcon render --help`\n");
}

}  // namespace
}  // namespace capcon::testing
