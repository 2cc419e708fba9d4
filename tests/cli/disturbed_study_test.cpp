#include "cli/disturbed_study.h"

#include <cstdlib>

namespace capcon::testing {
namespace {

/// Kills a kind of study: CAPCON_KILLS=100 for a release, few in CI.
int wanted_kills() {
  const char* text = std::getenv("CAPCON_KILLS");
  return text ? std::atoi(text) : 4;
}

/// What a stopped study says, and how it ends; before its first steps it may not know signals yet.
void expect_stopped(const Outcome& end) {
  if (end.exit_code == -SIGINT) return;
  EXPECT_EQ(end.exit_code, 130);
  EXPECT_EQ(end.err.rfind("capcon: stopped; ", 0), 0u) << end.err;
  EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 1) << end.err;
}

class DisturbedStudy : public ::testing::TestWithParam<StudyKind> {};

// Ended at moments all over its run, by kill -9 and by Ctrl-C in turn, and started again until it is done.
TEST_P(DisturbedStudy, EndsWithTheResultsOfAnUndisturbedOne) {
  const Folder folder;
  const std::string words =
      "study " + GetParam().name + " " + tiny_scene(folder) + " " + GetParam().options + " -o ";
  const double start = now();
  const Outcome straight = run(words + (folder / "straight"));
  const double whole = now() - start;
  ASSERT_EQ(straight.exit_code, 0) << straight.err;
  const int kills = wanted_kills();
  int killed = 0, done = 0;
  for (std::uint64_t i = 0; killed < kills || done == 0; ++i) {
    Process study(words + (folder / "disturbed"));
    const bool last = killed >= kills || i > 20u * static_cast<unsigned>(kills);
    std::optional<Outcome> end = study.wait(last ? 100 : whole * moment(i));
    if (!end) {
      const int signal = killed % 2 ? SIGINT : SIGKILL;
      end = study.end(signal);
      if (end->exit_code != 0) {  // else it was done just before
        ++killed;
        if (signal == SIGINT) expect_stopped(*end);
        continue;
      }
    }
    ASSERT_EQ(end->exit_code, 0) << end->err;
    expect_equal_results(folder / "disturbed", folder / "straight");
    std::filesystem::remove_all(folder / "disturbed");
    ++done;
  }
  std::printf("%s: %d ends, %d studies done, each as the undisturbed one\n", GetParam().name.c_str(), killed,
              done);
  EXPECT_GE(killed, kills);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DisturbedStudy, ::testing::ValuesIn(study_kinds()), [](const auto& kind) {
  std::string name = kind.param.name;
  std::erase(name, '-');
  return name;
});

/// A study long enough to be met at its work.
std::string long_study(const Folder& folder) {
  return "study ambient-occlusion " + tiny_scene(folder) +
         " --radius 2 --samples 1,4 --seeds 2000 --samplers random --reference-samples 16 --no-close-ups "
         "--width 8 --height 6 --device reference --quiet -o " +
         (folder / "r");
}

void wait_for_lines(const std::string& path, int lines) {
  for (const double until = now() + 60; now() < until;) {
    const std::string bytes = contents(path);
    if (std::count(bytes.begin(), bytes.end(), '\n') >= lines) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL() << path << " does not grow";
}

TEST(StudyFolder, OneStudyAtATime) {
  const Folder folder;
  const std::string words = long_study(folder);
  Process first(words);
  wait_for_lines(folder / "r/runs.jsonl", 3);
  const Outcome second = run(words);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_NE(second.err.find("another study is running in this folder"), std::string::npos) << second.err;
  first.end(SIGKILL);
  Process third(words);  // nothing of the dead one's blocks
  const auto before = contents(folder / "r/runs.jsonl");
  wait_for_lines(folder / "r/runs.jsonl",
                 static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 2);
  const double sent = now();
  const Outcome stopped = third.end(SIGTERM);
  EXPECT_LT(now() - sent, 2) << "half a second on a machine with nothing else to do";
  EXPECT_EQ(stopped.exit_code, 143);
  EXPECT_NE(stopped.err.find("of 4000 runs are kept in "), std::string::npos) << stopped.err;
  EXPECT_NE(stopped.err.find("the same command goes on"), std::string::npos) << stopped.err;
}

TEST(StudyFolder, ThatVanishesEndsTheStudy) {
  const Folder folder;
  Process study(long_study(folder));
  wait_for_lines(folder / "r/runs.jsonl", 3);
  std::filesystem::rename(folder / "r", folder / "elsewhere");
  const auto end = study.wait(60);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->exit_code, 1);
  EXPECT_NE(end->err.find("runs.jsonl: was removed or replaced"), std::string::npos) << end->err;
}

TEST(StudyFolder, ThatCannotBeMadeIsSaid) {
  const Folder folder;
  const std::string words = "study ambient-occlusion " + tiny_scene(folder) + " --device reference -o ";
  for (const std::string& place : {std::string("/proc/nothing"), folder.write("file", "mine")}) {
    const Outcome end = run(words + place);
    EXPECT_EQ(end.exit_code, 1);
    EXPECT_EQ(end.err.rfind("capcon: cannot ", 0), 0u) << end.err;
    EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 1) << end.err;
  }
  EXPECT_EQ(contents(folder / "file"), "mine");
}

}  // namespace
}  // namespace capcon::testing
