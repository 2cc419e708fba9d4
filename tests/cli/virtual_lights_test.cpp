#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

/// A floor and a wall, lit from above by a disk.
std::string lit_corner(const Folder& folder) {
  return folder.write("corner.pbrt",
                      "LookAt 0 -6 2 0 0 1 0 0 1\nCamera \"perspective\" \"float fov\" 60\n"
                      "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 24\nWorldBegin\n"
                      "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0 0 3\n"
                      "Rotate 180 1 0 0\nShape \"disk\" \"float radius\" 0.6\nAttributeEnd\n"
                      "Material \"diffuse\" \"rgb reflectance\" [0.7 0.6 0.5]\n"
                      "Shape \"disk\" \"float radius\" 9\nTranslate 0 2 0\nRotate 90 1 0 0\n"
                      "Shape \"disk\" \"float radius\" 9\n");
}

std::string lights_of(const Folder& folder, const std::string& name, const std::string& device) {
  return "render " + lit_corner(folder) + " --integrator igi --paths 16 --sets 2 --quiet --device " + device +
         " --show-virtual-lights " + (folder / name);
}

TEST(VirtualLights, ListsOfBothSidesAgree) {
  const Folder folder;
  const Outcome device = run(lights_of(folder, "device.json", "lavapipe"));
  ASSERT_EQ(device.exit_code, 0) << device.err;
  const Outcome reference = run(lights_of(folder, "reference.json", "reference"));
  ASSERT_EQ(reference.exit_code, 0) << reference.err;
  const json a = json::parse(contents(folder / "device.json"));
  const json b = json::parse(contents(folder / "reference.json"));
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 20u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].at("set"), b[i].at("set"));
    EXPECT_EQ(a[i].at("path"), b[i].at("path"));
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(a[i]["position"][k].get<double>(), b[i]["position"][k].get<double>(), 1e-3);
  }
  ASSERT_EQ(run(lights_of(folder, "lights.csv", "lavapipe")).exit_code, 0);
  const std::string csv = contents(folder / "lights.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), a.size() + 1);
}

TEST(VirtualLights, PictureBesideTheImage) {
  const Folder folder;
  const Outcome outcome = run(lights_of(folder, "lights.png", "lavapipe") + " -o " + (folder / "image.png"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(contents(folder / "lights.png").substr(1, 3), "PNG");
  EXPECT_EQ(contents(folder / "image.png").substr(1, 3), "PNG");
}

TEST(VirtualLights, WhatDoesNotGoTogetherIsSaid) {
  const Folder folder;
  const Outcome other = run("render " + lit_corner(folder) + " --integrator direct --show-virtual-lights " +
                            (folder / "a.png"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("--show-virtual-lights is for --integrator igi"), std::string::npos) << other.err;
  const Outcome name = run(lights_of(folder, "a.exr", "lavapipe"));
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_NE(name.err.find(".png (a picture), .csv or .json (a list)"), std::string::npos) << name.err;
}

TEST(VirtualLights, StudyOnTheReference) {
  const Folder folder;
  const Outcome study =
      run("study igi " + lit_corner(folder) +
          " --samplers sobol-owen --sets 1,2 --paths 16 --seeds 3 --reference-sets 8 --width 8 --height 6 "
          "--no-close-ups --quiet --device reference --json -o " +
          (folder / "s"));
  ASSERT_EQ(study.exit_code, 0) << study.err;
  EXPECT_GT(json::parse(study.out).at("curves")[0]["cells"][0]["mean_mse"].get<double>(), 0);
}

TEST(VirtualLights, StudyOfLightPaths) {
  const Folder folder;
  const std::string words =
      "study igi " + lit_corner(folder) +
      " --samplers sobol-xor,capcon,capcon-naive --sets 1,2 --paths 16 --seeds 3 "
      "--reference-sets 8 --width 16 --height 12 --no-close-ups --quiet --device lavapipe --json -o " +
      (folder / "s");
  const Outcome first = run(words);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const json study = json::parse(first.out);
  EXPECT_EQ(study.at("study"), "igi");
  EXPECT_EQ(study.at("settings").at("paths"), 16);
  EXPECT_EQ(study.at("noise").at("cells").size(), 6u);
  EXPECT_EQ(
      run("study igi " + lit_corner(folder) + " --sets 65536 --paths 65536 -o " + (folder / "x")).exit_code,
      2);
}

}  // namespace
}  // namespace capcon::testing
