// Points of a user's file as a sampler: renders, studies, integrals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image.h"

namespace capcon::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string scene_in(const Folder& folder) {
  return folder.write("s.pbrt",
                      "LookAt 0 -4 3 0 0 0 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 12 \"integer yresolution\" 8\nWorldBegin\n"
                      "LightSource \"infinite\"\nShape \"disk\" \"float radius\" 5\nTranslate 0 0 0.5\nShape "
                      "\"sphere\" \"float radius\" 0.5\n");
}

TEST(PointFiles, RenderAlikeOnDeviceAndReference) {
  const Folder folder;
  const std::string file = folder / "my points, 2.txt";
  ASSERT_EQ(run("points sobol-owen -n 64 -o '" + file + "'").exit_code, 0);
  const auto words = [&](const char* split, const char* device, const std::string& image) {
    return "render " + scene_in(folder) + " --integrator direct --split " + split +
           " --sampler 'file:" + file + "' --json --device " + device + " -o " + (folder / image);
  };
  const Outcome device = run(words("4x4", "lavapipe", "a.exr"));
  ASSERT_EQ(device.exit_code, 0) << device.err;
  EXPECT_EQ(json::parse(device.out).at("sampler"), "my_points__2");
  EXPECT_EQ(json::parse(device.out).at("sampler_file"), file);
  Attributes attributes;
  read_exr(folder / "a.exr", &attributes);
  EXPECT_EQ(std::get<std::string>(attributes.at("sampler")), "my_points__2");
  EXPECT_EQ(std::get<std::string>(attributes.at("samplerFile")), file);
  ASSERT_EQ(run(words("4x4", "reference", "b.exr")).exit_code, 0);
  const json same = json::parse(run("compare --json " + (folder / "a.exr") + " " + (folder / "b.exr")).out);
  EXPECT_LT(same.at("mean_difference"), 1e-5);
  const Outcome few = run(words("4x32", "reference", "c.exr"));
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.err, HasSubstr("128 points are asked for, and its largest set has 64"));
}

TEST(PointFiles, StudiesNameThemShortAndMeasureAChangedFileAnew) {
  const Folder folder;
  const std::string file = folder / "mine.txt", report = folder / "r";
  ASSERT_EQ(run("points sobol-owen -n 16 -o " + file).exit_code, 0);
  const std::string words = "study splitting " + scene_in(folder) +
                            " --seeds 2 --reference-samples 16 --width 8 "
                            "--no-close-ups --quiet --device reference -o " +
                            report + " --samplers random,file:" + file + ":xor,file:" + file + ":xor-naive";
  const Outcome first = run(words + " --combined 4");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("mine-xor-naive"));
  EXPECT_THAT(contents(report + "/runs.jsonl"), HasSubstr("\"sampler\":\"mine-xor\""));
  const std::string runs = contents(report + "/runs.jsonl");
  ASSERT_EQ(run(words + " --combined 4").exit_code, 0);
  EXPECT_EQ(contents(report + "/runs.jsonl"), runs) << "the same file: nothing is measured again";
  ASSERT_EQ(run("points sobol-owen -n 16 --seed 2 -o " + file).exit_code, 0);
  ASSERT_EQ(run(words + " --combined 4").exit_code, 0);
  EXPECT_NE(contents(report + "/runs.jsonl"), runs) << "another file: all is";
  const Outcome few = run(words + " --combined 32");
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.err, HasSubstr("32 points are asked for, and its largest set has 16"));
}

TEST(PointFiles, AreEstimatorsToo) {
  const Folder folder;
  const std::string file = folder / "random.txt";
  ASSERT_EQ(run("points sobol-owen -n 16 -o " + file).exit_code, 0);
  const Outcome outcome = run("integrate --integrands disk --estimators random,file:" + file +
                              " -n 16 --randomisations 50 --quiet");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("random-file"));
}

}  // namespace
}  // namespace capcon::testing
