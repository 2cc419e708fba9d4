// One study by several processes: shards merged, and ranks of an MPI job; one image by several ranks.
#include <algorithm>
#include <cstdlib>

#include "cli/disturbed_study.h"
#include "distributed/share_renderer.h"

namespace capcon::testing {
namespace {

/// Words that start so many ranks, more than there are cores maybe.
std::string mpirun(int ranks, const std::string& more = "") {
  // One machine: no other is asked for, nor another process's memory, which containers forbid.
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm=isolated "
         "OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun --oversubscribe --bind-to none " +
         more + " -n " + std::to_string(ranks);
}

bool no_mpi() {
  return !built_with_mpi() || std::system("mpirun --version >/dev/null 2>&1") != 0;
}
#define NEEDS_MPI() \
  if (no_mpi()) GTEST_SKIP() << "needs libopenmpi-dev when capcon is built, and openmpi-bin"

/// The tables: study.json without what clocks said.
nlohmann::json tables_of(const std::string& folder) {
  nlohmann::json json = nlohmann::json::parse(contents(folder + "/study.json"));
  forget_times(json);
  json.erase("clocks");
  return json;
}

int lines_of(const std::string& path) {
  const std::string bytes = contents(path);
  return static_cast<int>(std::count(bytes.begin(), bytes.end(), '\n'));
}

class SharedStudy : public ::testing::TestWithParam<StudyKind> {};

TEST_P(SharedStudy, HasTheTablesOfOneProcess) {
  const Folder folder;
  const std::string words =
      "study " + GetParam().name + " " + tiny_scene(folder) + " " + GetParam().options + " -o ";
  ASSERT_EQ(run(words + (folder / "one")).exit_code, 0);
  const nlohmann::json one = tables_of(folder / "one");
  for (const char* shard : {"4/4", "1/4", "3/4"})
    ASSERT_EQ(run(words + (folder / "four") + " --shard " + shard).exit_code, 0);
  const Outcome missing = run("merge " + (folder / "four"));
  EXPECT_EQ(missing.exit_code, 1);
  const std::size_t at = missing.err.find("of shard 2/4 (capcon study ");
  ASSERT_NE(at, std::string::npos) << missing.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "four/report.html"));
  // The command that it names does them.
  const std::size_t from = at + std::string("of shard 2/4 (capcon ").size();
  ASSERT_EQ(run(missing.err.substr(from, missing.err.rfind(')') - from)).exit_code, 0);
  const Outcome merged = run("merge --quiet " + (folder / "four"));
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(tables_of(folder / "four"), one);
  EXPECT_TRUE(std::filesystem::exists(folder / "four/report.html"));
  EXPECT_EQ(run(words + (folder / "three") + " --shard 2/4x").exit_code, 2);
  NEEDS_MPI();
  const Outcome three = run(words + (folder / "three"), mpirun(3));
  ASSERT_EQ(three.exit_code, 0) << three.err;
  EXPECT_EQ(tables_of(folder / "three"), one);
  EXPECT_NE(three.out.find("Mean squared error"), std::string::npos);
  EXPECT_EQ(three.out.find("Mean squared error"), three.out.rfind("Mean squared error")) << "told twice";
}

std::vector<StudyKind> two_kinds() {
  std::vector<StudyKind> kinds = study_kinds();
  return {kinds.front(), kinds.back()};  // the latter keeps images
}
INSTANTIATE_TEST_SUITE_P(Kinds, SharedStudy, ::testing::ValuesIn(two_kinds()), [](const auto& kind) {
  std::string name = kind.param.name;
  std::erase(name, '-');
  return name;
});

// Rank 1 is killed at its work, the launcher lets the others live: they finish, and the same command does the
// rest alone.
TEST(Ranks, AKilledOneLosesItsOwnUnfinishedJobsAlone) {
  NEEDS_MPI();
  const Folder folder;
  const std::string words = "study ambient-occlusion " + tiny_scene(folder) +
                            " --radius 2 --samples 1,4 --seeds 400 --samplers random --reference-samples 16 "
                            "--no-close-ups --width 8 --height 6 --device reference --quiet -o " +
                            (folder / "r");
  const auto log = [&](int i) { return folder / ("r/shards/" + std::to_string(i) + "-of-4/runs.jsonl"); };
  const std::string kills = folder.write(
      "kill", "if [ $OMPI_COMM_WORLD_RANK = 1 ]; then\n\"$@\" & p=$!\nuntil [ $(cat " + log(2) +
                  " 2>/dev/null | wc -l) -ge 9 ]; do sleep .002; done\nkill -9 $p; exit 137\nfi\n"
                  "exec \"$@\"\n");
  const Outcome killed = run(words, mpirun(4, "--enable-recovery") + " sh " + kills);
  // (What mpirun's own exit code says then is its business: with recovery, 0.)
  EXPECT_NE(killed.err.find("capcon: a rank died; "), std::string::npos) << killed.err;
  EXPECT_EQ(lines_of(log(1)), 201);
  EXPECT_EQ(lines_of(log(3)), 201);
  const int kept = lines_of(log(2)) - 1;
  ASSERT_LT(kept, 200);
  EXPECT_GE(kept, 8);
  const std::string first = contents(log(1)), third = contents(log(3));
  ASSERT_EQ(run(words, mpirun(4)).exit_code, 0);
  EXPECT_EQ(contents(log(1)), first);
  EXPECT_EQ(contents(log(3)), third);
  EXPECT_EQ(lines_of(log(2)), 201);
  EXPECT_EQ(lines_of(folder / "r/runs.jsonl"), 801);
}

TEST(Ranks, RenderOneImageTogether) {
  NEEDS_MPI();
  const Folder folder;
  const std::string words =
      "render " + tiny_scene(folder) + " --width 40 --height 30 --quiet --device lavapipe ";
  const auto difference = [&](const std::string& a, const std::string& b) {
    const Outcome told = run("compare --json " + (folder / a) + " " + (folder / b));
    return nlohmann::json::parse(told.out).at("max_difference").get<double>();
  };
  const std::string direct = words + "--integrator direct --split 6x2 --pixel-samples jittered -o ";
  ASSERT_EQ(run(direct + (folder / "one.exr")).exit_code, 0);
  for (const char* name : {"a.exr", "b.exr"}) {
    const Outcome together = run(direct + (folder / name), mpirun(2));
    ASSERT_EQ(together.exit_code, 0) << together.err;
  }
  EXPECT_EQ(difference("a.exr", "b.exr"), 0) << "not the same bits every time";
  EXPECT_LT(difference("a.exr", "one.exr"), 1e-5);
  const Outcome refused =
      run("render " + (folder / "tiny.pbrt") + " --device reference -o " + (folder / "no.exr"), mpirun(2));
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
}

TEST(Ranks, TakeTheDevicesInTurn) {
  EXPECT_EQ(device_of_rank("0,2,5", 1), "2");
  EXPECT_EQ(device_of_rank("0,2,5", 3), "0");
  EXPECT_FALSE(share_a_device("0,2,5", 3));
  EXPECT_TRUE(share_a_device("0,2,0", 3));
  EXPECT_TRUE(share_a_device("best", 2));
  EXPECT_FALSE(share_a_device("best", 1));
  for (const char* all : {"best", "3", "llvmpipe (LLVM 15.0.6, 256 bits)"})
    EXPECT_EQ(device_of_rank(all, 1), all);
}

// A baseline of this very study holds; one in which a sampler did better does not; another scene's is
// refused.
TEST(StudyCheck, JudgesAndNames) {
  const Folder folder;
  const std::string words = "study ambient-occlusion " + tiny_scene(folder) +
                            " --samples 1,2,4 --reference-samples 256 --width 8 --height 6 --seeds 4 "
                            "--samplers random,sobol-owen,capcon --device reference --quiet --no-close-ups ";
  const std::string checked = "-o " + (folder / "r") + " --check ";
  ASSERT_EQ(run(words + "--radius 2 -o " + (folder / "r")).exit_code, 0);
  const Outcome same = run(words + "--radius 2 " + checked + (folder / "r/study.json"));
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find(" figures of equal error hold against "), std::string::npos) << same.out;
  nlohmann::json better = nlohmann::json::parse(contents(folder / "r/study.json"));
  for (nlohmann::json& ratio : better["ratios"]) {
    if (ratio["sampler"] != "capcon" || !ratio["equal_error_samples"]["value"].is_number()) continue;
    for (nlohmann::json& v : ratio["equal_error_samples"]) v = v.get<double>() / 8;
  }
  folder.write("better.json", better.dump());
  const Outcome worse = run(words + "--radius 2 " + checked + (folder / "better.json"));
  EXPECT_EQ(worse.exit_code, 1) << worse.out;
  EXPECT_NE(worse.out.find("capcon: samples needed for the error of "), std::string::npos) << worse.out;
  EXPECT_EQ(worse.out.find("random: samples needed"), std::string::npos) << worse.out;
  EXPECT_NE(worse.err.find("figures of equal error are worse than in "), std::string::npos) << worse.err;
  const Outcome other = run(words + "--radius 3 " + checked + (folder / "r/study.json"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("study.json: radius is 2.0 there and 3.0 in this study"), std::string::npos)
      << other.err;
}

}  // namespace
}  // namespace capcon::testing
