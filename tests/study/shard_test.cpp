#include "study/shard.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/clocks.h"
#include "study/merge.h"
#include "study/study.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

StudySettings small_settings() {
  StudySettings s = fake_settings();
  s.width = 16;
  s.height = 10;
  s.samples = {1, 4, 16};
  s.seeds = 3;
  s.reference_samples = 1024;
  s.command = "capcon study ambient-occlusion fake --shard 1/4";
  return s;
}

RunnerOptions into(const fs::path& folder) {
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  return options;
}

/// As a process of its own; `renders` counts.
StudyResult run(const StudySettings& s, const fs::path& folder, const Shard& shard,
                const StudyDevice& device) {
  const Ranks alone;
  return run_shard(s, device, into(folder), shard, shared_reference(s, device, into(folder), alone));
}
StudyResult run(const StudySettings& s, const fs::path& folder, const Shard& shard, int* renders = nullptr) {
  return run(s, folder, shard, fake_device(renders)(s.width, s.height));
}

/// Everything that a study says, times of the clock and words about processes aside.
nlohmann::json figures_of(const StudyResult& result) {
  nlohmann::json json = to_json(result, make_figures(result));
  for (const char* name : {"started", "clocks"}) json.erase(name);
  for (nlohmann::json& curve : json["curves"])
    for (nlohmann::json& cell : curve["cells"])
      for (const char* clock : {"wall_seconds", "wall_seconds_without_points"}) cell.erase(clock);
  return json;
}

template <class Error>
std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Shard, EveryJobIsInOne) {
  const auto plan = plan_runs(small_settings());
  std::vector<int> times(plan.size());
  for (std::uint32_t i = 1; i <= 5; ++i) {
    const auto jobs = Shard{i, 5}.jobs(plan);
    EXPECT_NEAR(static_cast<double>(jobs.size()), plan.size() / 5.0, 1);
    for (const PlannedRun& job : jobs) ++times[std::find(plan.begin(), plan.end(), job) - plan.begin()];
  }
  EXPECT_EQ(times, std::vector<int>(plan.size(), 1));
  EXPECT_EQ(Shard::parse("12/34").str(), "12/34");
  for (const char* text : {"", "1", "0/4", "5/4", "1/4x", "a/b", "-1/4", "/"})
    EXPECT_THROW(Shard::parse(text), InputError) << text;
}

TEST(Shard, MergedTheyAreTheStudyOfOneProcess) {
  const Folder folder;
  const StudySettings s = small_settings();
  const StudyResult one = run_study(s, fake_device()(s.width, s.height), into(folder / "one"));
  int renders = 0;
  for (const std::uint32_t i : {3u, 1u, 4u, 2u}) run(s, folder / "many", {i, 4}, &renders);
  EXPECT_LE(renders, 4 + 36 + 4 * (4 + 6));  // the reference once; warm-ups and calibration in each shard
  EXPECT_GT(renders, 4 + 36 + 4 * (4 + 6) - 4);
  const StudyResult merged = merge_shards(folder / "many", {folder / "many"});
  EXPECT_EQ(figures_of(merged), figures_of(one));
  EXPECT_EQ(merged.reference.image.pixels, one.reference.image.pixels);
  // One process goes on from there: nothing is left to do.
  int none = 0;
  const StudyResult again = run_study(s, fake_device(&none)(s.width, s.height), into(folder / "many"));
  EXPECT_EQ(none, 0);
  EXPECT_EQ(figures_of(again), figures_of(one));
  EXPECT_TRUE(again.moved.empty());
}

TEST(Shard, MissingJobsAreNamedWithTheirCommand) {
  const Folder folder;
  const StudySettings s = small_settings();
  for (const std::uint32_t i : {1u, 3u, 4u}) run(s, folder, {i, 4});
  const fs::path& place = folder;
  const std::string message = message_of<Failure>([&] { merge_shards(place, {place}); });
  EXPECT_EQ(message,
            "9 of 36 jobs are missing: 9 of shard 2/4 (capcon study ambient-occlusion fake --shard 2/4)");
  EXPECT_FALSE(fs::exists(folder / "runs.jsonl"));
  // However the rest is shared out: what is finished is not done again.
  int renders = 0;
  EXPECT_EQ(run(s, folder, {1, 1}, &renders).records.size(), 9u);
  EXPECT_LE(renders, 9 + 4 + 6);
  EXPECT_EQ(merge_shards(place, {place}).records.size(), 36u);
}

TEST(Shard, GoesOnWhereItWasEnded) {
  const Folder folder;
  const StudySettings s = small_settings();
  struct Ended {};
  StudyDevice device = fake_device()(s.width, s.height);
  device.render = [inner = device.render, left = 4 + 6 + 7](const Job& job) mutable {
    if (left-- == 0) throw Ended();
    return inner(job);
  };
  EXPECT_THROW(run(s, folder, {1, 2}, device), Ended);
  const std::size_t kept = read_runs(shard_folder(folder, {1, 2}) / "runs.jsonl").records.size();
  EXPECT_GT(kept, 2u);
  EXPECT_EQ(run(s, folder, {1, 2}).resumed, kept);
  run(s, folder, {2, 2});
  EXPECT_EQ(merge_shards(folder / "out", {folder}).records.size(), 36u);
}

TEST(Shard, OtherStudiesAreToldByWhatDiffers) {
  const Folder folder;
  StudySettings s = small_settings();
  run(s, folder / "a", {1, 2});
  s.radius = 5;
  run(s, folder / "b", {2, 2});
  std::string message = message_of<InputError>([&] {
    merge_shards(folder / "out", {folder / "a", folder / "b"});
  });
  EXPECT_NE(message.find("are not of one study: radius is 2.0 in one and 5.0 in the other"),
            std::string::npos)
      << message;
  s.radius = 2;
  StudyDevice other = fake_device()(s.width, s.height);  // whose last bits differ
  other.render = [inner = other.render](const Job& job) {
    RenderResult result = inner(job);
    result.image.pixels[0] = std::nextafter(result.image.pixels[0], 9.0f);
    return result;
  };
  run(s, folder / "c", {2, 2}, other);
  message = message_of<InputError>([&] { merge_shards(folder / "out", {folder / "a", folder / "c"}); });
  EXPECT_NE(message.find("measured against different reference images"), std::string::npos) << message;
  EXPECT_NE(
      message_of<InputError>([&] { merge_shards(folder / "out", {folder / "none"}); }).find("no shards"),
      std::string::npos);
  fs::copy_file(folder / "a/shards/reference.exr", folder / "c/shards/reference.exr",
                fs::copy_options::overwrite_existing);
  run(s, folder / "c", {2, 2}, other);
  EXPECT_EQ(merge_shards(folder / "out", {folder / "a", folder / "c"}).records.size(), 36u);
}

/// So many times as slow, by another name.
StudyDevice slow(const StudySettings& s, double factor, const std::string& name) {
  StudyDevice device = fake_device()(s.width, s.height);
  device.render = [inner = device.render, factor, name](const Job& job) {
    RenderResult result = inner(job);
    for (auto& [stage, seconds] : result.timings.device) seconds *= factor;
    result.device = name;
    return result;
  };
  return device;
}

TEST(Clocks, TimesAreScaledByEachProcessesOwnCalibration) {
  const Folder folder;
  const StudySettings s = small_settings();
  const Figures one = make_figures(run_study(s, fake_device()(s.width, s.height), into(folder / "one")));
  run(s, folder, {1, 2}, slow(s, 1, "fake"));
  run(s, folder, {2, 2}, slow(s, 3, "fake"));
  const fs::path& place = folder;
  const Figures merged = make_figures(merge_shards(folder / "out", {place}));
  EXPECT_NE(merged.clocks.find("2 clocks"), std::string::npos) << merged.clocks;
  EXPECT_NE(merged.clocks.find("(0.33 to 1.00)"), std::string::npos) << merged.clocks;
  for (std::size_t i = 0; i < one.curves.size(); ++i) {
    for (std::size_t k = 0; k < one.curves[i].cells.size(); ++k)
      EXPECT_NEAR(
          merged.curves[i].cells[k].device_seconds.value / one.curves[i].cells[k].device_seconds.value, 1,
          1e-9);
  }
  EXPECT_NEAR(merged.ratio("capcon", "sobol-xor", 4)->equal_time.value,
              one.ratio("capcon", "sobol-xor", 4)->equal_time.value, 1e-9);
  EXPECT_TRUE(one.clocks.empty());
}

TEST(Clocks, OfUnlikeDevicesAreNotCompared) {
  const Folder folder;
  const StudySettings s = small_settings();
  run(s, folder, {1, 2}, slow(s, 1, "fake"));
  run(s, folder, {2, 2}, slow(s, 3, "other"));
  const fs::path& place = folder;
  const StudyResult result = merge_shards(folder / "out", {place});
  const Figures merged = make_figures(result);
  for (const Ratio& ratio : merged.ratios) EXPECT_TRUE(std::isnan(ratio.equal_time.value));
  EXPECT_FALSE(std::isnan(merged.ratio("capcon", "sobol-xor", 4)->equal_error.value));
  EXPECT_EQ(to_json(result, merged)["clocks"].size(), 2u);
  EXPECT_NO_THROW(make_report(result, nullptr, into(folder / "out")));
}

}  // namespace
}  // namespace capcon
