#include "study/split_findings.h"

#include <gtest/gtest.h>

#include "study/fake_device.h"

namespace capcon {
namespace {

StudyResult split_study() {
  StudyResult result;
  result.settings = fake_settings();
  result.settings.integral = Integral::splitting;
  result.settings.combined = 16;
  result.settings.samples = {1, 4, 16};
  result.settings.seeds = 3;
  result.settings.samplers = {"capcon", "capcon-naive", "sobol-owen"};
  result.reference.error = 1e-9;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const double wobble = 1 + 0.01 * seed;
    for (const std::uint32_t p : {1u, 4u, 16u}) {
      result.records.push_back(exact_run("capcon", p, seed, wobble * (p == 4 ? 1.3e-3 : 1e-3), 0.1));
      result.records.push_back(exact_run("capcon-naive", p, seed, wobble * 1e-3 * p, 0.1));
      result.records.push_back(exact_run("sobol-owen", p, seed, wobble * 2e-3, 0.1));
    }
  }
  return result;
}

TEST(SplitFindings, FlatnessIsTheFarthestFromTheMean) {
  const auto all = flatness(make_figures(split_study()));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].variant, "capcon");
  EXPECT_EQ(all[0].at, 4u);
  EXPECT_NEAR(all[0].farthest, 1.3 / 1.1 - 1, 1e-6);
  EXPECT_NEAR(all[2].farthest, 0, 1e-9);
}

TEST(SplitFindings, NaiveStandsBesideItsSampler) {
  const Figures figures = make_figures(split_study());
  const Ratio* r = figures.ratio("capcon-naive", "capcon", 16);
  ASSERT_NE(r, nullptr);
  EXPECT_NEAR(r->mse.value, 16, 1e-3);
  const auto findings = make_split_findings(split_study().settings, figures);
  EXPECT_NE(findings[0].find("farthest at 4x4"), std::string::npos) << findings[0];
}

TEST(SplitFindings, PlacesOfTheirOwnAreNoFlatness) {
  StudyResult result = split_study();
  result.settings.position = PixelPosition::jittered;
  const auto findings = make_split_findings(result.settings, make_figures(result));
  EXPECT_NE(findings[0].find("at 1x16 and"), std::string::npos) << findings[0];
  for (const std::string& f : findings) EXPECT_EQ(f.find("stays within"), std::string::npos) << f;
}

TEST(SplitFindings, VariantsAreParsed) {
  EXPECT_TRUE(parse_variant("capcon").partition);
  EXPECT_EQ(parse_variant("capcon-domain").sampler, "capcon-domain");
  EXPECT_FALSE(parse_variant("sobol-owen-naive").partition);
  EXPECT_EQ(parse_variant("sobol-owen-naive").sampler, "sobol-owen");
  EXPECT_EQ(parse_variant("capcon-naive2").factor, 2u);
  const Job job = make_job(split_study().settings, {"capcon-naive2", 4, 1});
  EXPECT_EQ(std::get<DirectLightingJob>(job).integrator_samples, 8u);
  EXPECT_FALSE(std::get<DirectLightingJob>(job).partition);
}

}  // namespace
}  // namespace capcon
