// The same bytes for any number of threads, the host's and those of the software driver.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "image/image.h"

namespace capcon::testing {
namespace {

const char* const kScene =
    "LookAt 0 -4 3 0 0 .5 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
    "Film \"rgb\" \"integer xresolution\" 45 \"integer yresolution\" 31\nWorldBegin\n"
    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0.5 0 2\nRotate 180 1 0 0\n"
    "Shape \"disk\" \"float radius\" 0.6\nAttributeEnd\nMaterial \"diffuse\" \"rgb reflectance\" [0.6 0.4 "
    "0.3]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-2 -2 0 2 -2 0 2 1 0 -2 1 0 -2 1 2 2 1 2] \"integer indices\" "
    "[0 1 2 0 2 3 3 2 5 3 5 4]\nTranslate 0 0 .4 Shape \"sphere\" \"float radius\" .4\n";

class Threads : public ::testing::Test {
 protected:
  const Folder folder_;

  /// Runs `words` with 1, 2 and 4 threads, each with an output of its own, and calls same(first, other).
  template <class Same>
  void expect_same(const std::string& words, const std::string& suffix, const Same& same) const {
    std::string first;
    for (const std::string threads : {"1", "2", "4"}) {
      const std::string output = folder_ / (threads + suffix);
      // lavapipe's 0 is the calling thread alone.
      const Outcome outcome =
          run(words + " -o " + output,
              "CAPCON_THREADS=" + threads + " LP_NUM_THREADS=" + (threads == "1" ? "0" : threads));
      ASSERT_EQ(outcome.exit_code, 0) << words << "\n" << outcome.err;
      if (first.empty()) {
        first = output;
      } else {
        EXPECT_TRUE(same(first, output)) << threads << " threads: " << words;
      }
    }
  }
  void expect_same_pixels(const std::string& options) const {
    const std::string scene = folder_.write("s.pbrt", kScene);
    expect_same(
        "render " + scene + " --device lavapipe --quiet" + options, ".exr",
        [](const std::string& a, const std::string& b) { return read_exr(a).pixels == read_exr(b).pixels; });
  }
  void expect_same_bytes(const std::string& words, const std::string& suffix) const {
    expect_same(words, suffix, [](const std::string& a, const std::string& b) {
      return !contents(a).empty() && contents(a) == contents(b);
    });
  }
};

TEST_F(Threads, Renders) {
  expect_same_pixels(" --samples 16 --radius 2");
  expect_same_pixels(" --integrator direct --split 2x4 --pixel-samples jittered --sampler capcon-domain");
  expect_same_pixels(" --integrator igi --sets 2 --paths 64 --gather 2 --split 2x2 --pixel-samples jittered");
}

TEST_F(Threads, Points) {
  expect_same_bytes("points ccvt -n 100 --capacity 100 --seed 3", ".txt");
  expect_same_bytes("points fpo -n 100 --seed 3", ".txt");
}

TEST_F(Threads, TilesAndParts) {
  expect_same_bytes("tiles make --points 4 --starts 1 --rounds 10 --tilings 3 --moves 200 -q", ".tiles");
  const std::string points = folder_ / "p.txt";
  ASSERT_EQ(run("points ccvt -n 64 --capacity 64 --quiet -o " + points).exit_code, 0);
  expect_same_bytes("partition " + points + " -k 4 --quiet", ".txt");
}

/// Without what was measured in seconds.
void drop_times(nlohmann::json& value) {
  if (value.is_object()) {
    value.erase("seconds");
    value.erase("cpu_seconds");
  }
  if (!value.is_structured()) return;
  for (nlohmann::json& inner : value) drop_times(inner);
}

TEST_F(Threads, Integrals) {
  expect_same(
      "integrate --integrands disk,edge-on-disk --estimators random,sobol-owen,ccvt -n 16 --randomisations "
      "50 --quiet",
      "", [](const std::string& a, const std::string& b) {
        auto first = nlohmann::json::parse(contents(a + "/results.json"));
        auto second = nlohmann::json::parse(contents(b + "/results.json"));
        drop_times(first), drop_times(second);
        return first.size() > 2 && first == second;
      });
}

}  // namespace
}  // namespace capcon::testing
