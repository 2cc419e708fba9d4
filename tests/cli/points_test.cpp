#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"

namespace capcon {
namespace {

using capcon::testing::Folder;
using capcon::testing::run;
using ::testing::HasSubstr;

TEST(Points, RefusesWhatMeansNothing) {
  const std::pair<const char*, const char*> cases[] = {
      {"nope", "no method \"nope\"; there are random, "},
      {"fpo --density x", "--density means nothing to fpo; it is for ccvt, lloyd, random, jittered"},
      {"sobol --domain disk", "--domain means nothing to sobol"},
      {"lattice --rounds 3", "--rounds means nothing to lattice; it is for lloyd"},
      {"lloyd --kind golden", "--kind means nothing to lloyd; it is for lattice"},
      {"random file.csv", "FILE means nothing to random; it is for import"},
      {"import", "import which file?"},
      {"import x.csv -n 3", "-n means nothing to import"},
      {"import none.csv", "none.csv: "},
      {"random --density 'x+z'", "column 3: no name \"z\""},
      {"random --density 'x-0.5'", "the density is -0.4995"},
      {"random --density 0", "0 everywhere"},
      {"random --density none.png", "none.png: "},
      {"jittered --density x --domain disk", "cannot have a density on the disk"},
  };
  for (const auto& [words, expected] : cases) {
    const auto outcome = run(std::string("points ") + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(expected));
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(Points, EchoesItsParameters) {
  const auto json = [](const std::string& words) {
    return nlohmann::json::parse(run("points " + words + " -n 5 --json --quiet").out);
  };
  EXPECT_EQ(json("fpo --strategy local")["strategy"], "local");
  EXPECT_EQ(json("lloyd --rounds 7")["rounds"], 7);
  EXPECT_EQ(json("lattice --kind golden --shift")["kind"], "golden");
  EXPECT_EQ(json("lattice --shift")["shift"], true);
  const nlohmann::json disk = json("ccvt --capacity 16 --domain disk --density '1+x'");
  EXPECT_EQ(disk["domain"], "disk");
  EXPECT_EQ(disk["density"], "1+x");
  EXPECT_EQ(disk["sets"][0]["points"].size(), 5u);
  EXPECT_FALSE(disk.contains("measures"));
  EXPECT_TRUE(json("ccvt --capacity 16").contains("measures"));
}

TEST(Points, ImportsAndConverts) {
  const Folder folder;
  const std::string csv = folder.write("a.csv", "x;y\n0,5;0,25\n0;1\n"),
                    bad = folder.write("b.csv", "0,0\n0.5,2\n");
  EXPECT_EQ(run("points import " + csv).out, "0.5 0.25\n0 0\n");
  const auto outcome = run("points import " + bad + " -o " + folder / "c.txt");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("b.csv:2: 2 is not in [0, 1]"));
  EXPECT_EQ(folder.file_count(), 2u);
}

TEST(Points, FollowsTheBrightPartOfAnImage) {
  const Folder folder;
  // 2 x 1 pixels, grey, 8 bits: black, white (Python's zlib).
  const unsigned char png[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
      0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0xd1, 0x49, 0x20, 0x56, 0x00,
      0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0xf8, 0x0f, 0x00, 0x01, 0x02, 0x01,
      0x00, 0x42, 0xbe, 0xbc, 0x68, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const std::string image = folder.write("half.png", {reinterpret_cast<const char*>(png), sizeof png});
  const auto outcome = run("points ccvt -n 20 --capacity 16 --domain square --density " + image);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  int count = 0;
  for (double x, y; lines >> x >> y; ++count) EXPECT_GE(x, 0.5);
  EXPECT_EQ(count, 20);
}

// The energy that the finish lowers is told, and `capcon measure` says the same of the file.
TEST(Points, TheFinishReportsItsEnergy) {
  const Folder folder;
  const auto made = run("points ccvt -n 64 --finish transport -o " + (folder / "p.txt"));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto measured = nlohmann::json::parse(run("measure --json " + (folder / "p.txt")).out);
  const double energy = measured.at(0).at("energy_ot").get<double>();
  EXPECT_LT(energy, 1.03);
  char text[32];
  std::snprintf(text, sizeof text, "transport energy %.4f", energy);
  EXPECT_NE(made.err.find(text), std::string::npos) << made.err;
  const auto json = nlohmann::json::parse(run("points ccvt -n 64 --finish transport --json").out);
  EXPECT_NEAR(json.at("measures").at("energy_ot").get<double>(), energy, 1e-6);
}

}  // namespace
}  // namespace capcon
