#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/findings.h"
#include "study/study.h"

namespace capcon {
namespace {

StudySettings igi_settings() {
  StudySettings s = fake_settings();
  s.integral = Integral::global_illumination;
  s.samplers = {"sobol-xor", "sobol-owen", "capcon", "capcon-naive"};
  s.samples = {1, 4, 16};
  s.seeds = 5;
  s.reference_samples = 4096;
  return s;
}

/// Blotches of 8 x 8 pixels and noise of single pixels, of equal variance; half of it for capcon, and as much
/// again without partition. Counts its renders.
MakeStudyDevice igi_device(int* renders = nullptr) {
  return [renders](int width, int height) {
    const RenderJob render = [=](const Job& any) {
      const auto& job = std::get<GlobalIlluminationJob>(any);
      if (renders) ++*renders;
      const double part = job.sampler == "capcon" && job.partition ? 0.5 : 1;
      const double sd = std::sqrt(part * 0.02 / job.sets / 2);
      const std::uint64_t stream = fnv1a64(job.sampler) + job.sets * 2 + (job.partition ? 1 : 0);
      const auto normal = [&](std::uint64_t at) {
        const double u = 1 - uniform64(job.direct.seed, stream, 2 * at);
        const double v = uniform64(job.direct.seed, stream, 2 * at + 1);
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
      };
      RenderResult result;
      result.image = Image(width, height, 3);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const double error =
              normal(std::uint64_t(y) * width + x) + normal(1000000 + std::uint64_t(y / 8) * width + x / 8);
          for (int c = 0; c < 3; ++c)
            result.image.at(x, y, c) = static_cast<float>(fake_truth(x, y, width, height) + sd * error);
        }
      }
      result.rays = 1;
      result.device = "fake";
      result.timings.device = {{"gather", 1e-3 * job.sets}};
      return result;
    };
    return StudyDevice{render, {{"name", "fake device"}}};
  };
}

RunnerOptions into(const std::filesystem::path& folder) {
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  return options;
}

TEST(IgiStudy, OnlyLightPathsAreTheSamplers) {
  StudySettings s = igi_settings();
  s.paths = 64;
  s.limit = 2;
  const auto job = std::get<GlobalIlluminationJob>(make_job(s, {"capcon-naive", 4, 3}));
  EXPECT_EQ(job.sampler, "capcon");
  EXPECT_FALSE(job.partition);
  EXPECT_EQ(job.direct.sampler, "sobol-owen");
  EXPECT_EQ(job.direct.position, PixelPosition::centre);
  EXPECT_EQ(job.direct.seed, 3u);
  EXPECT_EQ(job.paths, 64u);
  EXPECT_EQ(job.sets, 4u);
  EXPECT_EQ(job.limit, 2);
  EXPECT_TRUE(job.only_indirect);
  EXPECT_EQ(job.gather, kGatherRays);
  EXPECT_EQ(job.clamping, Clamping::compensate);
  EXPECT_EQ(std::get<GlobalIlluminationJob>(make_job(s, {"capcon-naive2", 4, 3})).paths, 128u);
  const auto reference = std::get<GlobalIlluminationJob>(make_reference_job(s, 1));
  EXPECT_EQ(reference.sampler, "sobol-owen");
  EXPECT_EQ(reference.sets, 4096u);
  EXPECT_TRUE(reference.partition && reference.only_indirect);
  s.samples = {1u << 15};
  EXPECT_THROW(make_job(s, {"capcon", 1u << 15, 1}), InputError);
}

TEST(IgiStudy, HashFollowsPathsAndLimit) {
  const StudySettings s = igi_settings();
  const std::string hash = settings_hash(s, {});
  StudySettings other = s;
  other.paths = 64;
  EXPECT_NE(settings_hash(other, {}), hash);
  other = s;
  other.limit = 1;
  EXPECT_NE(settings_hash(other, {}), hash);
}

TEST(IgiStudy, FindsTheRatiosAndTheStructure) {
  const Folder folder;
  StudySettings s = igi_settings();
  const StudyReport report = study_report(s, igi_device(), into(folder));
  const Ratio* r = report.figures.ratio("capcon", "sobol-xor", 4);
  ASSERT_TRUE(r);
  // 35 blocks in 5 seeds carry half of the variance: sd 8 % of each mean, more between two.
  EXPECT_NEAR(r->mse.value, 0.5, 0.2);
  EXPECT_NEAR(report.figures.ratio("capcon-naive", "capcon", 4)->mse.value, 2, 0.8);
  const NoiseCell* cell = report.figures.noise.cell("sobol-xor", 4);
  ASSERT_TRUE(cell);
  EXPECT_NEAR(cell->coarse.value, 0.5, 0.12);
  EXPECT_NEAR(cell->deviation.value, std::sqrt(0.02 / 4), 0.012);
  EXPECT_EQ(report.figures.noise.cells.size(), 12u);
  EXPECT_EQ(report.figures.noise.maps.size(), 2u);  // sobol-xor and capcon
  EXPECT_EQ(report.json.at("noise").at("cells").size(), 12u);
  const auto findings = make_findings(s, report.figures);
  EXPECT_EQ(findings[1].find("MSE of capcon beside that of sobol-xor: 0."), 0u) << findings[1];
  EXPECT_NE(findings[1].find("at 16 sets"), std::string::npos) << findings[1];
  const std::string page = read_file(report.page);
  for (const char* part : {"Noise against structure", "Error against sets",
                           "MSE / MSE of sobol-xor at as many sets", "error of the mean", "docs/igi.md"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find(">nan"), std::string::npos);
}

TEST(IgiStudy, ResumedItGivesTheSameFigures) {
  const Folder folder;
  const StudySettings s = igi_settings();
  const StudyReport whole = study_report(s, igi_device(), into(folder / "whole"));
  struct Ended {};
  const MakeStudyDevice ends = [](int width, int height) {
    StudyDevice device = igi_device()(width, height);
    device.render = [inner = device.render, left = 34](const Job& job) mutable {
      if (left-- == 0) throw Ended();
      return inner(job);
    };
    return device;
  };
  EXPECT_THROW(study_report(s, ends, into(folder / "stopped")), Ended);
  const StudyReport resumed = study_report(s, igi_device(), into(folder / "stopped"));
  EXPECT_GT(resumed.result.resumed, 20u);
  EXPECT_EQ(resumed.json.at("noise").dump(), whole.json.at("noise").dump());
  // An image that somebody removed is rendered again; nothing else is.
  std::filesystem::remove(folder / "stopped/images/capcon-4-2.exr");
  int renders = 0;
  const StudyReport again = study_report(s, igi_device(&renders), into(folder / "stopped"));
  EXPECT_EQ(renders, 1);
  EXPECT_EQ(again.json.at("noise").dump(), whole.json.at("noise").dump());
}

}  // namespace
}  // namespace capcon
