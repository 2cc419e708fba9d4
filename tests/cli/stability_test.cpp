#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace capcon::testing {
namespace {

// A case of each kind: 13 seconds on two cores.
TEST(Stability, TheShortFormPasses) {
  const Folder folder;
  const Outcome o = run("stability --brief --device lavapipe --quiet --json -o " + (folder / "out"));
  ASSERT_EQ(o.exit_code, 0) << o.err << o.out;
  const auto report = nlohmann::json::parse(o.out);
  EXPECT_TRUE(report.at("passed").get<bool>());
  EXPECT_EQ(report.at("checks").size(), 17u);
  for (const auto& check : report.at("checks")) {
    EXPECT_GT(check.at("values").get<int>(), 0) << check;
    EXPECT_NE(check.at("bound"), "") << check;
    EXPECT_NE(check.at("reason"), "") << check;
  }
  EXPECT_NE(contents(folder / "out/stability.html").find("17 of 17 checks passed"), std::string::npos);
  EXPECT_NE(contents(folder / "out/scenes/needles.pbrt").find("WorldBegin"), std::string::npos);
}

TEST(Stability, UnknownNamesAreOneSentence) {
  const Outcome o = run("stability --only nothing");
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "capcon: there is no check or group \"nothing\"; capcon stability --list names them\n");
  const Outcome device = run("stability --brief --device nothing");
  EXPECT_EQ(device.exit_code, 2);
  EXPECT_EQ(device.out, "");
  const Outcome list = run("stability --list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_NE(list.out.find("watertight"), std::string::npos);
}

}  // namespace
}  // namespace capcon::testing
