#include "study/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "base/error.h"
#include "fake_device.h"

namespace capcon {
namespace {

using testing::ElementsAre;

TEST(Plan, HoldsEveryRunOnce) {
  const StudySettings s = fake_settings();
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> seen;
  for (const PlannedRun& run : plan_runs(s)) seen.insert({run.sampler, run.samples, run.seed});
  EXPECT_EQ(seen.size(), plan_runs(s).size());
  EXPECT_EQ(seen.size(), s.samplers.size() * s.samples.size() * s.seeds);
}

TEST(Plan, InterleavesSoThatDriftHitsAllAlike) {
  StudySettings s = fake_settings();
  s.seeds = 100;
  const auto plan = plan_runs(s);
  // Every block of one (seed, samples) holds every sampler, and over the blocks each sampler stands in each
  // place about as often: 700 blocks, expected 175, standard deviation 11.5.
  std::map<std::string, std::map<std::size_t, int>> places;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const PlannedRun& first = plan[i - i % 4];
    EXPECT_EQ(plan[i].seed, first.seed);
    EXPECT_EQ(plan[i].samples, first.samples);
    ++places[plan[i].sampler][i % 4];
  }
  for (const auto& [sampler, counts] : places) {
    for (const auto& [place, count] : counts) EXPECT_NEAR(count, 175, 46) << sampler << " " << place;
  }
  EXPECT_EQ(plan, plan_runs(s));
}

TEST(Plan, HashFollowsWhatChangesAMeasurement) {
  const StudySettings s = fake_settings();
  const nlohmann::json device = {{"name", "a"}};
  const std::string hash = settings_hash(s, device);
  StudySettings extended = s;
  extended.seeds = 16;
  extended.samples = {1};
  extended.samplers = {"capcon"};
  extended.command = "other";
  EXPECT_EQ(settings_hash(extended, device), hash);
  const auto differs = [&](auto change) {
    StudySettings other = s;
    change(other);
    return settings_hash(other, device) != hash;
  };
  EXPECT_TRUE(differs([](StudySettings& o) { o.width = 41; }));
  EXPECT_TRUE(differs([](StudySettings& o) { o.radius = 3; }));
  EXPECT_TRUE(differs([](StudySettings& o) { o.reference_samples = 1; }));
  EXPECT_TRUE(differs([](StudySettings& o) { o.scene_fingerprint = 1; }));
  EXPECT_TRUE(differs([](StudySettings& o) { o.points_fingerprint = 1; }));
  EXPECT_NE(settings_hash(s, {{"name", "b"}}), hash);
}

TEST(Plan, ReadsSampleLists) {
  EXPECT_THAT(parse_samples("1,2,4..256"), ElementsAre(1, 2, 4, 8, 16, 32, 64, 128, 256));
  EXPECT_THAT(parse_samples("9,3..24,3"), ElementsAre(3, 6, 9, 12, 24));
  EXPECT_THAT(parse_samples("5..9"), ElementsAre(5));
  for (const char* wrong :
       {"", "0", "1,", "-1", "8..4", "1..", "a", "1.5", "99999999999", "4...8", "1048577", "0..8"}) {
    EXPECT_THROW(parse_samples(wrong), InputError) << wrong;
  }
}

}  // namespace
}  // namespace capcon
