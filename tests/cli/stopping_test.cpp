#include <nlohmann/json.hpp>

#include "cli/disturbed_study.h"

namespace capcon::testing {
namespace {

// Long work of every kind, stopped in its middle: at once, and without a file.
TEST(Stopping, LeavesNothingAndTakesNoTime) {
  const Folder folder;
  const std::string scene = tiny_scene(folder);
  const std::vector<std::string> all = {
      "render " + scene + " --device reference --width 800 --height 600 --samples 4096 -o ",
      "render " + scene + " --device lavapipe --width 800 --height 600 --samples 4096 -o ",
      "points ccvt -n 16384 --capacity 1024 -o ",
      "points fpo -n 8192 -o ",
      "tiles make -o ",
      "tiles parts -o "};
  std::filesystem::create_directory(folder / "out");
  for (std::size_t i = 0; i < all.size(); ++i) {
    Process process(all[i] + (folder / "out/a.exr"));
    EXPECT_FALSE(process.wait(0.4)) << "too quick to be stopped: " << all[i];
    const double sent = now();
    const Outcome end = process.end(i % 2 ? SIGTERM : SIGINT);
    EXPECT_LT(now() - sent, 2) << all[i];  // milliseconds, where the machine has nothing else to do
    EXPECT_EQ(end.exit_code, i % 2 ? 143 : 130) << all[i];
    EXPECT_EQ(end.err, "capcon: stopped; no file is left half written; give the same command again\n");
    EXPECT_TRUE(std::filesystem::is_empty(folder / "out")) << all[i];
  }
  std::filesystem::create_directory(folder / "report");
  Process integrate("integrate --quiet -o " + (folder / "report"));
  EXPECT_FALSE(integrate.wait(0.4));
  EXPECT_EQ(integrate.end(SIGINT).exit_code, 130);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "report"));
}

TEST(Stopping, AnImageIsCompleteOrAbsent) {
  const Folder folder;
  const std::string words = "render " + tiny_scene(folder) +
                            " --device reference --width 320 --height 240 --samples 4 --radius 2 --quiet -o ";
  const double start = now();
  ASSERT_EQ(run(words + (folder / "straight.exr")).exit_code, 0);
  const double whole = now() - start;
  std::filesystem::create_directory(folder / "out");
  const std::string out = folder / "out/a.exr";
  const auto expect_equal = [&] {
    const Outcome same = run("compare --json " + out + " " + (folder / "straight.exr"));
    ASSERT_EQ(same.exit_code, 0) << same.err;
    EXPECT_EQ(nlohmann::json::parse(same.out).at("max_difference"), 0);
  };
  for (std::uint64_t i = 0; i < 6; ++i) {
    Process process(words + out);
    if (!process.wait(whole * (0.5 + 0.6 * moment(i)))) process.end(SIGKILL);
    if (std::filesystem::exists(out)) expect_equal();
    std::filesystem::remove(out);
  }
  ASSERT_EQ(run(words + out).exit_code, 0);
  expect_equal();
  EXPECT_EQ(files_in(folder / "out"), 1u) << "what a killed render left is taken over";
}

// Rows of a large image that is stopped stay, and no other program writes between them.
TEST(Stopping, ALargeImageKeepsItsRows) {
  const Folder folder;
  const std::string words =
      "render " + tiny_scene(folder) + " --width 1500 --height 1500 --samples 32 --device lavapipe -o ";
  const std::string partial = folder / "a.exr.partial";
  Process first(words + (folder / "a.exr"));
  for (const double until = now() + 60; now() < until;) {
    std::error_code error;
    if (std::filesystem::exists(partial, error)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const Outcome second = run(words + (folder / "a.exr"));
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_NE(second.err.find("another capcon is rendering into this file"), std::string::npos) << second.err;
  const Outcome end = first.end(SIGINT);
  EXPECT_EQ(end.exit_code, 130);
  EXPECT_NE(end.err.find("rows are kept in " + partial), std::string::npos) << end.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

}  // namespace
}  // namespace capcon::testing
