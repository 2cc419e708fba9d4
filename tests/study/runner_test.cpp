#include "study/runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/figures.h"
#include "study/study.h"
#include "study/study_lock.h"

namespace capcon {
namespace {

RunnerOptions into(const std::filesystem::path& folder) {
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  return options;
}

StudyResult run(const StudySettings& s, const RunnerOptions& options, int* renders = nullptr) {
  return run_study(s, fake_device(renders)(s.width, s.height), options);
}

/// A process ended during its render number `renders` (from 0): nothing that comes after it happens.
struct Ended {};
StudyResult run_until(int renders, const StudySettings& s, const std::filesystem::path& folder) {
  StudyDevice device = fake_device()(s.width, s.height);
  device.render = [inner = device.render, left = renders](const Job& job) mutable {
    if (left-- == 0) throw Ended();
    return inner(job);
  };
  return run_study(s, device, into(folder));
}

TEST(Runner, ReferenceKnowsItsError) {
  const Folder folder;
  const StudySettings s = fake_settings();
  const StudyResult result = run(s, into(folder));
  const double truth = 0.2 * std::pow(4096, -1.25) / 4;  // variance of a mean of four
  double error = 0;
  for (int y = 0; y < s.height; ++y) {
    for (int x = 0; x < s.width; ++x) {
      error += std::pow(result.reference.image.at(x, y, 0) - fake_truth(x, y, s.width, s.height), 2) /
               (s.width * s.height);
    }
  }
  EXPECT_NEAR(result.reference.error / truth, 1, 0.12);  // 3,000 degrees of freedom: sd 2.6 %
  EXPECT_NEAR(error / truth, 1, 0.2);                    // 1,000 pixels: sd 4.5 %
}

TEST(Runner, RecoversKnownLawsWithinItsIntervals) {
  const Folder folder;
  const Figures figures = make_figures(run(fake_settings(), into(folder)));
  int covered = 0;
  int cells = 0;
  for (const Curve& curve : figures.curves) {
    const FakeLaw law = fake_law(curve.sampler);
    EXPECT_NEAR(curve.slope.value, -law.p, 0.03) << curve.sampler;
    EXPECT_LT(curve.slope.high - curve.slope.low, 0.06);
    for (const Cell& cell : curve.cells) {
      ASSERT_TRUE(cell.sure);
      const double truth = law.c * std::pow(cell.samples, -law.p);
      ++cells;
      covered += cell.mse.low <= truth && truth <= cell.mse.high ? 1 : 0;
      EXPECT_NEAR(cell.mse.value / truth, 1, 0.08);  // 8,000 pixels in all: sd 1.6 %
    }
  }
  EXPECT_GE(covered, cells * 0.8);  // 28 cells at 95 %
  const Ratio* r = figures.ratio("capcon", "sobol-xor", 16);
  EXPECT_NEAR(r->mse.value, 0.5, 0.05);
  EXPECT_NEAR(r->equal_error.value, 16 * std::pow(0.5, 0.8), 0.8);
  EXPECT_TRUE(r->mse.below(1) && r->equal_error.below(16));
  const Ratio* same = figures.ratio("sobol-owen", "sobol-xor", 16);
  EXPECT_NEAR(same->mse.value, 1, 0.08);
}

TEST(Runner, MakesOneLineARunAndGoesOnWhereItStopped) {
  const Folder whole_folder;
  const StudySettings s = fake_settings();
  const StudyResult whole = run(s, into(whole_folder / "whole"));
  const RunFile file = read_runs(whole_folder / "whole/runs.jsonl");
  EXPECT_EQ(file.records.size(), plan_runs(s).size());
  EXPECT_EQ(file.header["settings"]["width"], 40);

  const int before = 4 + static_cast<int>(s.samplers.size());  // the reference's groups and warm-ups
  EXPECT_THROW(run_until(97 + before, s, whole_folder / "stopped"), Ended);
  const RunFile part = read_runs(whole_folder / "stopped/runs.jsonl");
  EXPECT_EQ(part.records.size(), 97u);
  int renders = 0;
  const StudyResult resumed = run(s, into(whole_folder / "stopped"), &renders);
  EXPECT_EQ(resumed.resumed, 97u);
  EXPECT_EQ(renders,
            static_cast<int>(plan_runs(s).size() - 97 + s.samplers.size()));  // and one warm-up a sampler
  ASSERT_EQ(resumed.records.size(), whole.records.size());
  for (std::size_t i = 0; i < whole.records.size(); ++i) {
    EXPECT_EQ(resumed.records[i].run, whole.records[i].run);
    EXPECT_EQ(resumed.records[i].mse, whole.records[i].mse);
    EXPECT_EQ(resumed.records[i].device_seconds, whole.records[i].device_seconds);
  }
  EXPECT_EQ(resumed.reference.error, whole.reference.error);
  int none = 0;
  run(s, into(whole_folder / "stopped"), &none);
  EXPECT_EQ(none, 0);
}

// Wherever it was ended, times included: the fake device's are always the same.
TEST(Runner, EveryPointOfInterruptionGivesTheSameResult) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.width = 8;
  s.height = 5;
  s.samples = {1, 4};
  s.seeds = 2;
  s.reference_samples = 16;
  const auto figures_of = [&](const StudyResult& result) {
    nlohmann::json json = to_json(result, make_figures(result));
    json.erase("started");
    for (nlohmann::json& curve : json["curves"])
      for (nlohmann::json& cell : curve["cells"])
        for (const char* clock : {"wall_seconds", "wall_seconds_without_points"}) cell.erase(clock);
    return json;
  };
  int renders = 0;
  const StudyResult straight =
      run_study(s, fake_device(&renders)(s.width, s.height), into(folder / "straight"));
  ASSERT_EQ(renders, 4 + 4 + 16);
  for (int k = 0; k < renders; ++k) {
    const auto name = folder / ("ended-" + std::to_string(k)).c_str();
    EXPECT_THROW(run_until(k, s, name), Ended);
    // Ended again, before anything and right after one more render, then to the end.
    EXPECT_THROW(run_until(0, s, name), Ended);
    if (k + 6 < renders) {
      EXPECT_THROW(run_until(1, s, name), Ended);
    }
    const StudyResult resumed = run(s, into(name));
    EXPECT_EQ(figures_of(resumed), figures_of(straight)) << k;
    EXPECT_EQ(resumed.reference.image.pixels, straight.reference.image.pixels) << k;
    EXPECT_EQ(read_runs(name / "runs.jsonl").records.size(), 16u) << k;
    EXPECT_FALSE(std::filesystem::exists(name / "runs.1.jsonl")) << k;
  }
}

// Cut anywhere, header included: what is whole is kept, the rest measured again.
TEST(Runner, ALogCutAtAnyByteGoesOn) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.width = 4;
  s.height = 3;
  s.samples = {1};
  s.seeds = 1;
  s.samplers = {"random", "capcon"};
  s.reference_samples = 4;
  const StudyResult straight = run(s, into(folder));
  const std::string whole = read_file(folder / "runs.jsonl");
  const std::size_t header = whole.find('\n') + 1;
  for (std::size_t bytes = header; bytes <= whole.size(); bytes += 31) {
    write_file(folder / "runs.jsonl", whole.substr(0, bytes));
    const StudyResult resumed = run(s, into(folder));
    ASSERT_EQ(resumed.records.size(), 2u);
    EXPECT_EQ(resumed.resumed,
              static_cast<std::size_t>(std::count(whole.begin() + static_cast<std::ptrdiff_t>(header),
                                                  whole.begin() + static_cast<std::ptrdiff_t>(bytes), '\n')));
    EXPECT_EQ(resumed.records[1].mse, straight.records[1].mse);
    EXPECT_TRUE(resumed.moved.empty());
  }
}

TEST(Runner, AFolderThatVanishesEndsTheStudy) {
  const Folder folder;
  const StudySettings s = fake_settings();
  StudyDevice device = fake_device()(s.width, s.height);
  int renders = 0;
  device.render = [&, inner = device.render](const Job& job) {
    if (++renders == 20) std::filesystem::remove_all(folder / "r");
    return inner(job);
  };
  EXPECT_THROW(run_study(s, device, into(folder / "r")), Failure);
  EXPECT_EQ(renders, 20) << "went on measuring for nobody";
}

TEST(Runner, OneStudyAFolder) {
  const Folder folder;
  {
    const StudyLock first(folder / "r");
    EXPECT_THROW(StudyLock(folder / "r"), Failure);
    EXPECT_NO_THROW(StudyLock(folder / "other"));
  }
  EXPECT_NO_THROW(StudyLock(folder / "r"));
}

TEST(Runner, ExtendsAStudyAndKeepsOtherSettingsApart) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.seeds = 2;
  run(s, into(folder));
  s.seeds = 3;
  EXPECT_EQ(run(s, into(folder)).resumed, 2 * s.samples.size() * s.samplers.size());
  s.radius = 5;
  const StudyResult other = run(s, into(folder));
  EXPECT_EQ(other.resumed, 0u);
  EXPECT_EQ(other.moved, folder / "runs.1.jsonl");
  EXPECT_EQ(read_runs(other.moved).records.size(), 3 * s.samples.size() * s.samplers.size());
  RunnerOptions fresh = into(folder);
  fresh.fresh = true;
  EXPECT_EQ(run(s, fresh).moved, folder / "runs.2.jsonl");
}

TEST(Runner, AnUnfinishedLineIsMeasuredAgain) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.seeds = 1;
  run(s, into(folder));
  std::string bytes = read_file(folder / "runs.jsonl");
  write_file(folder / "runs.jsonl", bytes.substr(0, bytes.size() - 20));
  EXPECT_EQ(run(s, into(folder)).resumed, plan_runs(s).size() - 1);
  EXPECT_EQ(read_runs(folder / "runs.jsonl").records.size(), plan_runs(s).size());
}

TEST(Runner, MalformedLinesAreTheUsersToMend) {
  const Folder folder;
  StudySettings s = fake_settings();
  s.seeds = 1;
  run(s, into(folder));
  const std::string good = read_file(folder / "runs.jsonl");
  const std::size_t second = good.find('\n') + 1;
  for (const std::string wrong : {"{}\n", "nonsense\n", "[1]\n", "{\"sampler\":\"a\",\"samples\":\"x\"}\n"}) {
    write_file(folder / "runs.jsonl", good.substr(0, second) + wrong + good.substr(second));
    try {
      run(s, into(folder));
      FAIL() << wrong;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("runs.jsonl:2: "), std::string::npos) << error.what();
    }
  }
  write_file(folder / "runs.jsonl", "someone else's notes\n");
  EXPECT_THROW(run(s, into(folder)), InputError);
  EXPECT_EQ(read_file(folder / "runs.jsonl"), "someone else's notes\n");
}

TEST(Runner, FolderThatCannotBeMadeIsAFailure) {
  const Folder folder;
  write_file(folder / "file", "x");
  EXPECT_THROW(run(fake_settings(), into(folder / "file/study")), Failure);
}

}  // namespace
}  // namespace capcon
