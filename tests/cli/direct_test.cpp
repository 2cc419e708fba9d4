#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

/// A floor under a disk light, and a sky.
std::string lit_scene(const Folder& folder) {
  return folder.write(
      "lit.pbrt",
      "LookAt 0 -4 3 0 0 0 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
      "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16\nWorldBegin\n"
      "LightSource \"infinite\" \"rgb L\" [0.1 0.1 0.2]\n"
      "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0.5 0 2\nRotate 180 1 0 0\n"
      "Shape \"disk\" \"float radius\" 0.6\nAttributeEnd\n"
      "Material \"coateddiffuse\" \"rgb reflectance\" [0.6 0.4 0.3] \"float roughness\" 0.2\n"
      "Shape \"disk\" \"float radius\" 5\nTranslate 0 0 0.5\nShape \"sphere\" \"float radius\" 0.5\n");
}

TEST(Direct, RendersOnDeviceAndReferenceAlike) {
  const Folder folder;
  const std::string words =
      "render " + lit_scene(folder) +
      " --integrator direct --split 4x4 --pixel-samples jittered --filter gaussian --sampler "
      "capcon-domain --json -o ";
  const Outcome device = run(words + (folder / "a.exr") + " --device lavapipe");
  ASSERT_EQ(device.exit_code, 0) << device.err;
  const json report = json::parse(device.out);
  EXPECT_EQ(report.at("split"), "4x4");
  EXPECT_EQ(report.at("samples"), 16);
  EXPECT_EQ(report.at("integrator"), "direct");
  ASSERT_EQ(run(words + (folder / "b.exr") + " --device reference").exit_code, 0);
  const json same = json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / "b.exr")).out);
  EXPECT_LT(same.at("beyond"), 0.01);
  EXPECT_LT(same.at("mean_difference"), 1e-5);
}

TEST(Direct, WhatDoesNotGoTogetherIsSaid) {
  const Folder folder;
  const std::string scene = "render " + lit_scene(folder) + " -o " + (folder / "a.exr") + " ";
  const auto said = [&](const std::string& words, const std::string& sentence) {
    const Outcome outcome = run(scene + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << words << "\n" << outcome.err;
  };
  said("--integrator direct --split 4by4", "--split 4by4: must be PxI");
  said("--integrator direct --split 0x4", "--split 0x4: must be PxI");
  said("--integrator direct --split 4x4 --samples 16", "--split");
  said("--split 4x4", "are for --integrator direct");
  said("--integrator direct --radius 2", "--radius is for --integrator ao");
  said("--integrator direct --filter gaussian", "--pixel-samples jittered");
  said("--integrator direct --sampler halotn", "there is no sampler \"halotn\"");
}

TEST(Direct, ASceneWithoutLightIsSaidOnBothSides) {
  const Folder folder;
  const std::string scene =
      folder.write("dark.pbrt", "Camera \"perspective\"\nWorldBegin\nTranslate 0 0 4\nShape \"sphere\"\n");
  for (const char* device : {"lavapipe", "reference"}) {
    const Outcome dark =
        run("render " + scene + " --integrator direct --samples 1 --width 8 --height 8 --device " + device +
            " -o " + (folder / "a.exr"));
    EXPECT_EQ(dark.exit_code, 0) << dark.err;
    EXPECT_NE(dark.err.find("the scene has no light"), std::string::npos) << device << dark.err;
  }
}

TEST(Direct, StudiesOfLightAndOfSplits) {
  const Folder folder;
  const std::string scene = lit_scene(folder);
  const std::string small = " --reference-samples 64 --no-close-ups --quiet --device lavapipe --json -o ";
  const Outcome direct =
      run("study direct " + scene + " --samplers sobol-owen,capcon-domain --samples 4,16 --seeds 3" + small +
          (folder / "d"));
  ASSERT_EQ(direct.exit_code, 0) << direct.err;
  const json light = json::parse(direct.out);
  EXPECT_EQ(light.at("study"), "direct");
  EXPECT_EQ(light.at("curves").size(), 2u);
  EXPECT_NE(contents(folder / "d/report.html").find("Direct lighting"), std::string::npos);
  const Outcome splitting =
      run("study splitting " + scene + " --samplers capcon,capcon-naive,sobol-owen --seeds 3" + small +
          (folder / "s"));
  ASSERT_EQ(splitting.exit_code, 0) << splitting.err;
  const json splits = json::parse(splitting.out);
  EXPECT_EQ(splits.at("settings").at("samples"), json({1, 2, 4, 8, 16}));
  EXPECT_EQ(run("study splitting " + scene + " --samplers halotn-naive" + small + (folder / "x")).exit_code,
            2);
}

}  // namespace
}  // namespace capcon::testing
