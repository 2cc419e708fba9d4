#include <gtest/gtest.h>

#include <algorithm>

#include "cli/program.h"

namespace capcon::testing {
namespace {

const char* const kScene =
    "Camera \"perspective\" \"float fov\" 40\nFilm \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\nWorldBegin\n"
    "Translate 0 0 3\nShape \"sphere\"\n";

/// One sentence, no more than a line, that holds every word of `words`.
void expect_sentence(const Outcome& run, int exit_code, const std::vector<std::string>& words) {
  EXPECT_EQ(run.exit_code, exit_code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(run.err.rfind("capcon: ", 0), 0u) << run.err;
  for (const std::string& word : words) EXPECT_NE(run.err.find(word), std::string::npos) << "no \"" << word << "\" in: " << run.err;
}

TEST(Errors, CommandLine) {
  expect_sentence(run(""), 2, {"--help"});
  expect_sentence(run("rendre x"), 2, {"--help"});
  expect_sentence(run("render"), 2, {"scene", "render --help"});
  expect_sentence(run("render x.pbrt -o out.jpg"), 2, {".exr", ".png"});
  expect_sentence(run("render x.pbrt -o /tmp/x.exr --samples 0"), 2, {"--samples"});
  expect_sentence(run("render x.pbrt -o /tmp/x.exr --radius -1"), 2, {"--radius"});
  expect_sentence(run("render x.pbrt -o /tmp/x.exr --radius nan"), 2, {"--radius"});
  expect_sentence(run("points ccvt -n 0"), 2, {"0"});
  expect_sentence(run("points ccvd -n 4"), 2, {"ccvd", "ccvt"});
}

TEST(Errors, SceneFiles) {
  const Folder folder;
  const std::string out = " -o " + (folder / "out.exr");
  expect_sentence(run("render " + (folder / "missing.pbrt") + out), 2, {"missing.pbrt", "No such file"});
  expect_sentence(run("render " + folder.write("unknown.pbrt", "WorldBegin\nShepe \"sphere\"\n") + out), 2,
                  {"unknown.pbrt:2:1", "Shepe", "Shape"});
  expect_sentence(run("render " + folder.write("nan.pbrt",
                                               "WorldBegin\nShape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 nan 1 0]\n \"integer "
                                               "indices\" [0 1 2]\n") +
                      out),
                  2, {"nan.pbrt:2:"});
  folder.write("broken.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n");
  expect_sentence(run("render " + folder.write("mesh.pbrt", "WorldBegin\nShape \"plymesh\" \"string filename\" \"broken.ply\"\n") +
                      out),
                  2, {"broken.ply"});
  expect_sentence(run("render " + folder.write("loop.pbrt", "Include \"loop.pbrt\"\n") + out), 2, {"loop.pbrt:1:", "circle"});
  expect_sentence(run("render " + folder.write("empty.pbrt", "WorldBegin\n") + out + " --quiet"), 2, {"nothing to render"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out.exr"));
}

TEST(Errors, Outputs) {
  const Folder folder;
  const std::string scene = folder.write("s.pbrt", kScene);
  expect_sentence(run("render " + scene + " -o " + (folder / "no/such/folder/out.exr")), 1, {"cannot write", "No such file"});
  std::filesystem::create_directory(folder / "out.exr");
  expect_sentence(run("render " + scene + " -o " + (folder / "out.exr")), 1, {"cannot write", "directory"});
  EXPECT_EQ(folder.file_count(), 2u) << "something half written is left";
  expect_sentence(run("points random -n 4 -o /proc/nothing"), 1, {"cannot write"});
}

TEST(Errors, Devices) {
  const Folder folder;
  const std::string words = "render " + folder.write("s.pbrt", kScene) + " --quiet -o " + (folder / "out.exr");
  // A loader that finds no driver: --device reference is the way out, and works.
  const std::string none = "env VK_DRIVER_FILES=/nonexistent.json VK_ICD_FILENAMES=/nonexistent.json";
  expect_sentence(run(words, none), 1, {"no Vulkan", "mesa-vulkan-drivers", "reference"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out.exr"));
  EXPECT_EQ(run(words + " --device reference", none).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "out.exr"));
  expect_sentence(run(words + " --device 99"), 2, {"99", "llvmpipe"});
  EXPECT_EQ(run("info", none).exit_code, 0);
}

TEST(Errors, TileFiles) {
  const Folder folder;
  const std::string good = contents(std::string(CAPCON_SOURCE_DIR) + "/tiles/c2n16.tiles");
  ASSERT_FALSE(good.empty());
  expect_sentence(run("tiles verify " + folder.write("cut.tiles", good.substr(0, good.size() / 2))), 2, {"cut.tiles:"});
  expect_sentence(run("tiles verify " + folder.write("magic.tiles", "not tiles\n")), 2, {"magic.tiles:1"});
  std::string flipped = good;
  const std::size_t digit = good.size() / 2 + good.substr(good.size() / 2).find_first_of("12345678");
  ++flipped[digit];
  expect_sentence(run("tiles verify " + folder.write("flip.tiles", flipped)), 2, {"flip.tiles", "checksum"});
}

TEST(Errors, PointFiles) {
  const Folder folder;
  expect_sentence(run("measure " + folder.write("p.txt", "0.5 0.5\n0.25 abc\n")), 2, {"p.txt:2"});
  expect_sentence(run("measure " + folder.write("q.txt", "0.5 0.5\n0.25 1.5\n")), 2, {"q.txt:2"});
  expect_sentence(run("measure " + (folder / "none.txt")), 2, {"none.txt"});
}

}  // namespace
}  // namespace capcon::testing
