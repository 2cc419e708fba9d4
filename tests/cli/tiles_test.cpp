#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using nlohmann::json;

std::vector<std::string> point_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line != "#") lines.push_back(line);
  std::ranges::sort(lines);
  return lines;
}

TEST(Tiles, VerifySaysThatTheShippedSetsAreGood) {
  const Outcome outcome = run("tiles verify c3n16-compact --tilings 4 --untiled 1 --capacity 64 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report.at("tiles"), 35);
  EXPECT_EQ(report.at("colouring"), "apart");
  EXPECT_EQ(report.at("prefixes").size(), 16u);
  EXPECT_GE(report.at("least_prefix_delta_mean"), 0.7);
  EXPECT_LT(report.at("spike").at("ratio"), 3);
  EXPECT_TRUE(report.at("ok"));
}

// Farthest-point tiles repeat: said, and the exit code tells.
TEST(Tiles, MakeAndVerifyFarthestPoints) {
  const Folder folder;
  const std::string file = folder / "f.tiles";
  const Outcome made =
      run("tiles make --method fpo --starts 1 --rounds 40 --moves 10 --json -o " + file, "CAPCON_THREADS=1");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_GT(json::parse(made.out).at("figures").at("delta_mean"), 0.85);
  const Outcome verified = run("tiles verify " + file + " --tilings 3 --untiled 1");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_NE(verified.out.find("farthest-point sets"), std::string::npos);
  EXPECT_NE(verified.out.find("above 3"), std::string::npos);
}

// The recipe of tiles/README.md.
TEST(Tiles, PartsAreTheShippedOnes) {
  const Folder folder;
  const Outcome outcome = run("tiles parts -o " + (folder / "p.parts"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(contents(folder / "p.parts"), contents(CAPCON_SOURCE_DIR "/tiles/c2n16.parts"));
  EXPECT_EQ(run("tiles parts").exit_code, 2);
}

// Said where they are used, with what to do; without the file all is as before.
TEST(Tiles, BrokenPartsAreOneClearSentence) {
  const Folder folder;
  std::filesystem::create_directories(folder / "tiles");
  std::filesystem::copy_file(CAPCON_SOURCE_DIR "/tiles/c2n16.tiles", folder / "tiles/c2n16.tiles");
  const std::string parts = contents(CAPCON_SOURCE_DIR "/tiles/c2n16.parts");
  folder.write("tiles/c2n16.parts", parts.substr(0, parts.size() / 2));
  const std::string scene = folder.write("s.pbrt",
                                         "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6\n"
                                         "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n"
                                         "Translate 0 0 4\nShape \"sphere\"\n");
  const std::string words =
                        "render " + scene +
                        " --integrator direct --split 4x4 --sampler capcon --device reference --quiet -o " +
                        (folder / "a.exr"),
                    data = "CAPCON_DATA=" + (folder / "");
  const Outcome broken = run(words, data);
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_NE(broken.err.find("capcon tiles parts -o FILE"), std::string::npos) << broken.err;
  EXPECT_EQ(std::count(broken.err.begin(), broken.err.end(), '\n'), 1) << broken.err;
  std::filesystem::remove(folder / "tiles/c2n16.parts");
  const Outcome without = run(words, data);
  EXPECT_EQ(without.exit_code, 0) << without.err;
}

TEST(Tiles, SheetIsAPicture) {
  const Folder folder;
  const Outcome outcome =
      run("tiles sheet shipped --tilings 2 --untiled 1 --capacity 16 --scale 0.5 -o " + (folder / "s.png"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(contents(folder / "s.png").substr(1, 3), "PNG");
  EXPECT_EQ(run("tiles sheet shipped -o " + (folder / "s.txt")).exit_code, 2);
}

TEST(Tiles, PartitionCutsATilingAndKeepsItsPoints) {
  const Folder folder;
  const std::string words = "partition --tiles shipped --width 4 --tiling 3 -k ";
  const Outcome whole = run(words + "1"), parts = run(words + "4");
  ASSERT_EQ(parts.exit_code, 0) << parts.err;
  EXPECT_EQ(point_lines(whole.out).size(), 256u);
  EXPECT_EQ(point_lines(whole.out), point_lines(parts.out));
  EXPECT_EQ(std::count(parts.out.begin(), parts.out.end(), '#'), 3);
  const json figures = json::parse(run(words + "4 --json").out);
  EXPECT_EQ(figures.at("tiles"), 16);
  EXPECT_EQ(figures.at("sets").size(), 4u);
  EXPECT_GT(figures.at("delta_mean_worst"), 0.75);
  EXPECT_EQ(run("partition -k 2").exit_code, 2);
  EXPECT_EQ(run("partition --tiles nothing.tiles -k 2").exit_code, 2);
}

// Tiles with a border from making to points, and what is not to be.
TEST(Tiles, BoundedSetsFillTheSquare) {
  const Folder folder;
  const std::string file = folder / "b.tiles";
  const Outcome made =
      run("tiles make --boundary --starts 1 --rounds 6 --tilings 3 --moves 20 --json -o " + file);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(contents(file).find("capcon-tiles 3\ncolours 3\n"), std::string::npos);
  const Outcome points = run("tiles points " + file + " --width 3 --count 2");
  ASSERT_EQ(points.exit_code, 0) << points.err;
  EXPECT_EQ(point_lines(points.out).size(), 288u);
  const Outcome shown = run("tiles show " + file + " --width 2 -o " + (folder / "b.svg"));
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  for (const std::string words :
       {"tiles points c2n16-bounded --width 1", "tiles show c2n16-bounded --width 1",
        "tiles make --boundary --compact", "tiles make --boundary --method fpo",
        "tiles make --boundary --shared-edge 1", "tiles points c2n16-bounded --ranks 17"}) {
    const Outcome wrong = run(words);
    EXPECT_EQ(wrong.exit_code, 2) << words;
    EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
  }
}

TEST(Tiles, VerifySaysThatTheBoundedSetIsGood) {
  const Outcome outcome = run("tiles verify c2n16-bounded --tilings 20 --untiled 1 --capacity 64 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report.at("tiles"), 40);
  EXPECT_EQ(report.at("colouring"), "bounded");
  EXPECT_TRUE(report.at("even_cells"));
  EXPECT_EQ(report.at("tilings").size(), 4u);
  EXPECT_TRUE(report.at("ok"));
}

}  // namespace
}  // namespace capcon::testing
