// What goes wrong on a device, through the program as it is, under a layer that fails on demand
// (fault_layer/faults.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/program.h"
#include "image/image.h"

namespace capcon::testing {
namespace {

const char* const kScene =
    "LookAt 0 -4 3 0 0 .5 0 0 1\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n"
    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0.5 0 2\nRotate 180 1 0 0\n"
    "Shape \"disk\" \"float radius\" 0.6\nAttributeEnd\nMaterial \"diffuse\" \"rgb reflectance\" [0.6 0.4 "
    "0.3]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-2 -2 0 2 -2 0 2 1 0 -2 1 0 -2 1 2 2 1 2] \"integer indices\" "
    "[0 1 2 0 2 3 3 2 5 3 5 4]\n";
const std::string kAmbient = " --samples 4 --sampler sobol-xor --radius 2";
const std::string kDirect = " --integrator direct --samples 4 --sampler sobol-xor";
const std::string kIgi = " --integrator igi --sets 2 --paths 16 --sampler sobol-xor --path-sampler sobol-xor";

class Faults : public ::testing::Test {
 protected:
  const Folder folder_;
  const std::string scene_ = folder_.write("s.pbrt", kScene);

  static Outcome under(const std::string& faults, const std::string& words) {
    return run(words, "NODEVICE_SELECT=1 VK_ADD_LAYER_PATH=" CAPCON_LAYERS
                      " VK_INSTANCE_LAYERS=VK_LAYER_CAPCON_faults CAPCON_TEST_FAULTS=" +
                          faults);
  }
  std::string render_words(const std::string& options) const {
    return "render " + scene_ + options + " --device lavapipe --quiet -o " + (folder_ / "out.exr");
  }
  Outcome render(const std::string& faults, const std::string& options) const {
    return under(faults, render_words(options));
  }
  /// One sentence and nothing left behind.
  void expect_failure(const Outcome& run, const std::vector<std::string>& words) const {
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.err.rfind("capcon: ", 0), 0u) << run.err;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " in " << run.err;
    EXPECT_EQ(folder_.file_count(), 1u);
  }
  std::vector<float> pixels(const std::string& faults, const std::string& options) const {
    const Outcome outcome = render(faults, options);
    EXPECT_EQ(outcome.exit_code, 0) << faults << options << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "");
    if (outcome.exit_code != 0) return {};
    const Image image = read_exr(folder_ / "out.exr");
    std::filesystem::remove(folder_ / "out.exr");
    return image.pixels;
  }
  /// The layer's log: lanes of each dispatch, and how often each call came.
  struct Log {
    std::vector<std::uint64_t> dispatches;
    std::map<std::string, std::int64_t> calls;
  };
  Log take_log() const {
    Log log;
    std::istringstream lines(contents(folder_ / "log"));
    for (std::string word; lines >> word;) {
      if (std::isdigit(static_cast<unsigned char>(word[0]))) {
        log.dispatches.push_back(std::stoull(word));
      } else {
        lines >> log.calls[word];
      }
    }
    std::filesystem::remove(folder_ / "log");
    return log;
  }
};

const std::string kSmall = " --width 24 --height 16";

TEST_F(Faults, ALostDeviceIsSaidWheneverItIsLost) {
  for (const std::string& options : {kAmbient, kDirect, kIgi}) {
    ASSERT_FALSE(pixels("log=" + (folder_ / "log"), kSmall + options).empty());
    const std::int64_t submits = take_log().calls["submit"];
    EXPECT_GE(submits, 4);
    // Not the last: batches follow the device's clock, and another run may have a few less.
    for (const std::int64_t number : {submits / 2, 2 * submits / 3}) {
      const std::string call = number == submits / 2 ? "submit:" : "wait:";
      expect_failure(render(call + std::to_string(number) + "=device-lost", kSmall + options),
                     {"device lost", "try again", "--device", "reference"});
    }
  }
}

TEST_F(Faults, WhatTheDeviceLacksIsSaid) {
  const std::string options = kSmall + kAmbient;
  expect_failure(render("no-device", options),
                 {"there is no Vulkan device", "mesa-vulkan-drivers", "reference"});
  expect_failure(render("no-compute", options), {"has no compute queue", "reference"});
  expect_failure(render("no-timestamps", options), {"has no timestamps", "reference"});
  expect_failure(render("no-votes", options), {"has no subgroup votes and shuffles", "reference"});
  expect_failure(render("old", options), {"has no Vulkan 1.2", "reference"});
  expect_failure(render("bindings=4", options), {"binds at most 4 buffers to a kernel", "--device"});
  const Outcome best = under("old", "render " + scene_ + options + " --quiet -o " + (folder_ / "out.exr"));
  expect_failure(best, {"no Vulkan device can be used", "has no Vulkan 1.2", "reference"});
  EXPECT_NE(under("no-votes", "info").out.find("not usable: it has no subgroup votes"), std::string::npos);
}

TEST_F(Faults, WhatVulkanCannotMakeIsSaid) {
  expect_failure(render("pipeline:2=failed", kSmall + kDirect), {"cannot compile a kernel", "driver"});
  expect_failure(render("pipeline:1+=no-host-memory", kSmall + kAmbient),
                 {"cannot compile a kernel", "memory"});
  expect_failure(render("device:1=failed", kSmall + kAmbient), {"cannot create a device", "--device"});
  expect_failure(render("pool:1=no-host-memory", kSmall + kAmbient),
                 {"cannot create a command pool", "memory"});
  expect_failure(render("wait:2+=no-host-memory", kSmall + kAmbient), {"cannot finish the work", "memory"});
}

// Without room for the scene there is a sentence; without room for what is worked on at a time, that is less,
// and no bit of the image changes.
TEST_F(Faults, OutOfMemoryMeansLessAtATime) {
  const std::string size = " --width 151 --height 71";
  expect_failure(render("allocate:1+=no-device-memory", kSmall + kAmbient),
                 {"has no room", "out of device memory", "smaller"});
  expect_failure(render("allocate:4+=no-host-memory", kSmall + kIgi),
                 {"has no room", "out of host memory", "smaller"});
  expect_failure(render("heap=4096", kSmall + kDirect), {"has no room", "smaller"});
  for (const auto& [options, largest] : {std::pair(kAmbient, "200000"), std::pair(kIgi, "1700000")}) {
    const std::string words = options + size;
    const std::vector<float> plain = pixels("log=" + (folder_ / "log"), words);
    const Log before = take_log();
    EXPECT_EQ(pixels("log=" + (folder_ / "log") + ",largest=" + largest, words), plain);
    EXPECT_GT(take_log().dispatches.size(), before.dispatches.size()) << "in bands";
    const std::string last = std::to_string(before.calls.at("allocate"));
    EXPECT_EQ(pixels("allocate:" + last + "=no-device-memory", words), plain);
  }
}

// Where a heap is small, as where an allocation is refused.
TEST_F(Faults, SmallMemoryIsShared) {
  const std::string words = kDirect + " --width 151 --height 71";
  EXPECT_EQ(pixels("heap=1200000", words), pixels("", words));
}

TEST_F(Faults, BeyondWhatCanBeBoundIsSaidOrReadInAnotherWay) {
  const std::string words = kAmbient + " --width 211 --height 161";
  EXPECT_EQ(pixels("texels=65536", words), pixels("", words)) << "in bands: no device holds fewer texels";
  expect_failure(render("storage=64,texels=4", kSmall + kDirect),
                 {"binds at most", "are needed", "another --device"});
  // 300 triangles by storage buffers.
  std::string many = kScene;
  for (int i = 0; i < 300; ++i)
    many += "Translate 0 0 .001 Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 0 1 0]\n";
  folder_.write("s.pbrt", many);
  const std::string small = kSmall + kAmbient;
  EXPECT_EQ(pixels("texels=512", small), pixels("", small));
}

// The layer's GPU takes so long a lane that a dispatch of all would take 2 to 20 s, and loses the device at 2
// s.
TEST_F(Faults, ASlowDeviceGetsSmallDispatches) {
  for (const std::string& options : {kAmbient, kIgi}) {
    const std::string words = options + " --width 151 --height 71";
    const std::vector<float> plain = pixels("", words);
    for (const std::uint64_t nanoseconds : {40000u}) {
      const std::string lane = "lane=" + std::to_string(nanoseconds);
      EXPECT_EQ(pixels(lane + ",watchdog=2000000000,log=" + (folder_ / "log"), words), plain);
      const auto dispatches = take_log().dispatches;
      EXPECT_LE(*std::max_element(dispatches.begin(), dispatches.end()) * nanoseconds, 1500000000u);
    }
  }
  // And one that cannot be saved: the watchdog is what the test says it is.
  expect_failure(render("lane=1000000000,watchdog=2000000000", kSmall + kAmbient), {"device lost"});
}

TEST_F(Faults, AStudyKeepsWhatIsFinished) {
  const std::string words =
      "study ambient-occlusion " + scene_ +
      " --radius 2 --width 12 --height 8 --samples 1 --samplers random,sobol-xor --seeds 2 "
      "--reference-samples 16 --no-close-ups --device lavapipe --quiet -o " +
      (folder_ / "study");
  const Outcome lost = under("wait:21=device-lost", words);
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_EQ(std::count(lost.err.begin(), lost.err.end(), '\n'), 1) << lost.err;
  for (const char* word : {"device lost", " of 4 runs are kept in ", "the same command goes on from there"})
    EXPECT_NE(lost.err.find(word), std::string::npos) << lost.err;
  const std::string runs = contents(folder_ / "study/runs.jsonl");
  EXPECT_GE(std::count(runs.begin(), runs.end(), '\n'), 2) << lost.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "study/report.html"));
  ASSERT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(contents(folder_ / "study/runs.jsonl").rfind(runs, 0), 0u) << "what was kept is measured no more";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "study/report.html"));
}

}  // namespace
}  // namespace capcon::testing
