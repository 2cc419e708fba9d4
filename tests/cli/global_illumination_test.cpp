#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

/// A floor and a wall under a lamp.
std::string corner_scene(const Folder& folder, const std::string& lamp_turn = "Rotate 180 1 0 0") {
  return folder.write("corner.pbrt",
                      "LookAt 0 -4 3 0 0 .5 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16\nWorldBegin\n"
                      "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0.5 0 2\n" +
                          lamp_turn +
                          "\nShape \"disk\" \"float radius\" 0.6\nAttributeEnd\n"
                          "Material \"diffuse\" \"rgb reflectance\" [0.6 0.4 0.3]\n"
                          "Shape \"trianglemesh\" \"point3 P\" [-2 -2 0 2 -2 0 2 1 0 -2 1 0 -2 1 2 2 1 2] "
                          "\"integer indices\" "
                          "[0 1 2 0 2 3 3 2 5 3 5 4]\n");
}

TEST(GlobalIllumination, RendersOnDeviceAndReferenceAlikeAndTwiceTheSame) {
  const Folder folder;
  const std::string words =
      "render " + corner_scene(folder) +
      " --integrator igi --paths 32 --sets 4 --split 4x2 --pixel-samples jittered --gather 2 "
      "--path-sampler capcon-domain --sampler sobol-owen --json -o ";
  const Outcome device = run(words + (folder / "a.exr") + " --device lavapipe");
  ASSERT_EQ(device.exit_code, 0) << device.err;
  const json report = json::parse(device.out);
  EXPECT_EQ(report.at("sets"), 4);
  EXPECT_EQ(report.at("path_sampler"), "capcon-domain");
  EXPECT_GT(report.at("virtual_lights"), 50);
  ASSERT_EQ(run(words + (folder / "b.exr") + " --device lavapipe").exit_code, 0);
  const auto compared = [&](const char* other) {
    return json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / other)).out);
  };
  EXPECT_EQ(compared("b.exr").at("max_difference"), 0);
  // The reference's own paths end elsewhere where rounding parts them, which is rare with 128.
  ASSERT_EQ(run(words + (folder / "c.exr") + " --device reference").exit_code, 0);
  EXPECT_LT(compared("c.exr").at("mse"), 1e-6);
}

// Both converge to the same image: means of all pixels within a few percent at these counts.
TEST(GlobalIllumination, PathTracingOnTheReferenceAgrees) {
  const Folder folder;
  const std::string words = "render " + corner_scene(folder) + " --quiet --indirect ";
  ASSERT_EQ(
      run(words + "--integrator path --samples 256 --device reference -o " + (folder / "p.exr")).exit_code,
      0);
  ASSERT_EQ(run(words + "--integrator igi --sets 32 --samples 1 --device lavapipe -o " + (folder / "v.exr"))
                .exit_code,
            0);
  const json c = json::parse(run("compare --json " + (folder / "v.exr") + " " + (folder / "p.exr")).out);
  EXPECT_LT(c.at("mse_trimmed"), 2e-4);
  EXPECT_LT(std::abs(c.at("mean_difference").get<double>()), 4e-3);
}

TEST(GlobalIllumination, WhatDoesNotGoTogetherIsSaid) {
  const Folder folder;
  const std::string scene = "render " + corner_scene(folder) + " -o " + (folder / "a.exr") + " ";
  const auto said = [&](const std::string& words, const std::string& sentence, int code = 2) {
    const Outcome outcome = run(scene + words);
    EXPECT_EQ(outcome.exit_code, code) << words;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << words << "\n" << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.exr")) << words;
  };
  said("--integrator direct --sets 8", "are for --integrator igi");
  said("--integrator ao --indirect", "--indirect is for --integrator igi and path");
  said("--integrator igi --sets 6 --block 2", "multiple of 4, not 6");
  said("--integrator igi --sets 4 --pixel-samples jittered", "such as --split 4x4");
  said("--integrator igi --limit 0", "--limit");
  said("--integrator igi --paths 100000 --sets 64", "at most 2^20");
  said("--integrator igi --path-sampler halotn", "there is no sampler \"halotn\"");
  said("--integrator path --samples 1", "--device reference");
  // The lamp shines upwards, away from everything.
  corner_scene(folder, "");
  for (const char* device : {"lavapipe", "reference"})
    said(std::string("--integrator igi --device ") + device, "no light path hits a surface");
}

}  // namespace
}  // namespace capcon::testing
