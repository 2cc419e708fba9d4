#include <sys/mount.h>

#include <cerrno>
#include <cstring>

#include "cli/disturbed_study.h"

namespace capcon::testing {
namespace {

struct Writer {
  std::string words;  ///< of a verb, up to the file's name
  std::string file;
};

/// All verbs that write files, quick ones.
std::vector<Writer> writers(const Folder& folder) {
  const std::string scene = tiny_scene(folder), points = folder / "points.txt", image = folder / "image.exr",
                    other = folder / "other.exr";
  const std::string render = "render " + scene + " --device reference --samples 4 --radius 2 ";
  EXPECT_EQ(run("points random -n 256 --quiet -o " + points).exit_code, 0);
  EXPECT_EQ(run(render + "--width 64 --height 64 -o " + image).exit_code, 0);
  EXPECT_EQ(run(render + "--width 64 --height 64 --seed 2 -o " + other).exit_code, 0);
  return {
      {render + "-o ", "a.exr"},
      {render + "--width 64 --height 64 -o ", "a.png"},
      {"render " + scene + " --device reference --integrator igi --paths 8 --sets 1 --show-virtual-lights ",
       "lights.csv"},
      {"points sobol-owen -n 256 -o ", "p.txt"},
      {"partition " + points + " -k 4 -o ", "parts.txt"},
      {"measure " + points + " --plot ", "plot.svg"},
      {"measure " + points + " --plot ", "plot.png"},
      {"compare " + image + " " + other + " -o ", "difference.exr"},
      {"tiles show shipped --width 4 -o ", "tiling.svg"},
      {"tiles make --colours 1 --points 16 --starts 1 --rounds 2 --tilings 3 --moves 1 -o ", "a.tiles"},
      {"integrate --integrands disk --estimators random -n 4 --randomisations 2 -o ", "integrate"}};
}

/// One sentence that says what could not be written, why, and what to do.
void expect_refused(const Outcome& end, const std::string& words, const std::string& reason) {
  EXPECT_EQ(end.exit_code, 1) << words << "\n" << end.err;
  EXPECT_NE(end.err.find("capcon: cannot write "), std::string::npos) << words << "\n" << end.err;
  EXPECT_NE(end.err.find(reason), std::string::npos) << words << "\n" << end.err;
  EXPECT_NE(end.err.find("give the same command again"), std::string::npos) << end.err;
  EXPECT_EQ(end.err.find("internal error"), std::string::npos) << end.err;
}

// A limit of file sizes stands for a disk that is nearly full: the first 512 bytes are written, then no more.
TEST(FullDisk, EveryVerbSaysSoAndLeavesNothingHalfWritten) {
  const Folder folder;
  const auto all = writers(folder);
  std::filesystem::create_directory(folder / "out");
  for (const Writer& writer : all) {
    const std::string words = writer.words + (folder / "out/") + writer.file;
    expect_refused(run(words, "ulimit -f 1; "), words, "File too large");
    EXPECT_EQ(files_in(folder / "out"), 0u) << words;
  }
  for (const Writer& writer : all) {
    const Outcome end = run(writer.words + (folder / "out/") + writer.file);
    EXPECT_EQ(end.exit_code, 0) << writer.words << end.err;
  }
}

TEST(FullDisk, AFullOneToo) {
  const Folder folder;
  const auto all = writers(folder);
  const std::string disk = folder / "disk";
  std::filesystem::create_directory(disk);
  if (::mount("none", disk.c_str(), "tmpfs", 0, "size=512k") != 0)
    GTEST_SKIP() << "no small disk can be mounted here: " << std::strerror(errno);
  struct Unmount {
    std::string disk;
    ~Unmount() { ::umount2(disk.c_str(), MNT_DETACH); }
  } const unmount{disk};
  const auto fill = [&] {
    std::ofstream filler(disk + "/filler", std::ios::binary);
    while (filler << std::string(4096, 'x') << std::flush) {
    }
  };
  fill();
  for (const Writer& writer : all) {
    const std::string words = writer.words + disk + "/" + writer.file;
    expect_refused(run(words), words, "No space left on device");
    EXPECT_EQ(files_in(disk), 1u) << words;
  }
  // A study meets the full disk at three places, and goes on each time that it has room.
  const StudyKind kind = study_kinds().back();
  const std::string words = "study " + kind.name + " " + tiny_scene(folder) + " " + kind.options + " -o ";
  ASSERT_EQ(run(words + (folder / "straight")).exit_code, 0);
  for (const int pages : {3, 9, 20}) {
    std::filesystem::remove(disk + "/filler");
    fill();
    std::filesystem::resize_file(disk + "/filler",
                                 std::filesystem::file_size(disk + "/filler") - pages * 4096);
    expect_refused(run(words + disk + "/study"), words, "No space left on device");
  }
  std::filesystem::remove(disk + "/filler");
  const Outcome end = run(words + disk + "/study");
  ASSERT_EQ(end.exit_code, 0) << end.err;
  expect_equal_results(disk + "/study", folder / "straight");
}

// The log reaches the limit in the middle of a line, wherever that is.
TEST(FullDisk, AStudyGoesOnWhenThereIsRoom) {
  const Folder folder;
  const StudyKind kind = study_kinds().front();
  const std::string words = "study " + kind.name + " " + tiny_scene(folder) + " " + kind.options + " -o ";
  ASSERT_EQ(run(words + (folder / "straight")).exit_code, 0);
  for (const int blocks : {2, 6, 11, 17}) {
    const Outcome end = run(words + (folder / "r"), "ulimit -f " + std::to_string(blocks) + "; ");
    expect_refused(end, words, "File too large");
  }
  ASSERT_EQ(run(words + (folder / "r")).exit_code, 0);
  expect_equal_results(folder / "r", folder / "straight");
}

TEST(FullDisk, StandardOutputToo) {
  const Folder folder;
  const std::string err = folder / "err";
  for (const char* words :
       {"points random -n 5000", "points random -n 5000 -o /dev/full", "--help", "info --json"}) {
    const int status =
        std::system((std::string(CAPCON_PROGRAM) + " " + words + " >/dev/full 2>" + err).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << words;
    EXPECT_NE(contents(err).find("No space left on device"), std::string::npos) << words << contents(err);
  }
  // Both of them: nobody can be told, yet it ends as it should.
  const int status =
      std::system((std::string(CAPCON_PROGRAM) + " points random -n 5000 >/dev/full 2>&1").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(Outputs, PipesAndStandardOutputAreWrittenStraight) {
  const Folder folder;
  const std::string points = "points sobol-owen -n 4 --quiet", expected = run(points).out;
  EXPECT_EQ(run(points + " -o /dev/stdout").out, expected);
  const std::string command = CAPCON_PROGRAM " " + points + " -o /dev/stdout | cat >" + (folder / "piped");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(contents(folder / "piped"), expected);
  EXPECT_TRUE(std::filesystem::is_symlink("/dev/stdout"));
}

}  // namespace
}  // namespace capcon::testing
