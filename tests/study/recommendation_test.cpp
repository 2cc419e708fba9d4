#include "study/recommendation.h"

#include <gtest/gtest.h>

#include "fake_device.h"
#include "study/figures.h"
#include "study/findings.h"

namespace capcon {
namespace {

/// Exact laws: capcon has half the error of sobol-xor in the same time, sobol-owen needs twice the time.
StudyResult result_of(std::uint32_t seeds, const std::map<std::string, double>& spread) {
  StudyResult result{fake_settings(), {}, "", "", {}, {}, 0, {}};
  result.settings.seeds = seeds;
  for (const std::string& sampler : result.settings.samplers) {
    const FakeLaw law = fake_law(sampler);
    for (const std::uint32_t n : result.settings.samples) {
      for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        const auto at = spread.find(sampler);
        const double factor =
            at == spread.end() ? 1 + 0.001 * (seed % 3) : std::pow(at->second, seed % 2 ? 1 : -1);
        result.records.push_back(
            exact_run(sampler, n, seed, factor * law.c * std::pow(n, -law.p), law.seconds_per_sample * n));
      }
    }
  }
  return result;
}

TEST(Recommendation, NamesTheBestInEqualTime) {
  const StudyResult result = result_of(8, {});
  const Figures figures = make_figures(result);
  ASSERT_TRUE(figures.recommendation.has_value());
  const Recommendation& r = *figures.recommendation;
  EXPECT_EQ(r.sampler, "capcon");
  EXPECT_EQ(r.baseline, "sobol-owen");
  EXPECT_TRUE(r.by_time);
  // 64 of sobol-owen take the time of 128 of the others, which were not measured; its 32 take that of 64.
  EXPECT_EQ(r.samples, 32u);
  EXPECT_EQ(r.compared, 4u);
  EXPECT_NEAR(r.error.value, 0.5 * std::pow(2, -1.25), 0.01);
  EXPECT_TRUE(r.undecided.empty());
  EXPECT_EQ(make_findings(result.settings, figures)[0].find("Use capcon here: "), 0u)
      << make_findings(result.settings, figures)[0];
}

TEST(Recommendation, SaysWhatSeedsDoNotDecide) {
  const StudyResult result = result_of(8, {{"sobol-xor", 8}});
  const Figures figures = make_figures(result);
  ASSERT_TRUE(figures.recommendation.has_value());
  EXPECT_EQ(figures.recommendation->undecided, (std::vector<std::string>{"sobol-xor"}));
  EXPECT_NE(make_findings(result.settings, figures)[0].find("8 seeds do not show that sobol-xor errs more"),
            std::string::npos)
      << make_findings(result.settings, figures)[0];
}

TEST(Recommendation, TellsErrorsFromTimes) {
  // The clock of sobol-xor is wild, its error is not.
  StudyResult result = result_of(8, {});
  for (RunRecord& r : result.records) {
    if (r.run.sampler == "sobol-xor") r.device_seconds *= std::pow(8, r.run.seed % 2 ? 1 : -1);
  }
  const Figures figures = make_figures(result);
  ASSERT_TRUE(figures.recommendation.has_value());
  EXPECT_EQ(figures.recommendation->undecided, (std::vector<std::string>{"sobol-xor"}));
  EXPECT_TRUE(figures.recommendation->undecided_by_samples.empty());
  EXPECT_NE(make_findings(result.settings, figures)[0].find(
                "With as many samples each of the others is shown to err more."),
            std::string::npos)
      << make_findings(result.settings, figures)[0];
}

TEST(Recommendation, OfOneSeedIsNotSure) {
  const StudyResult result = result_of(1, {});
  const Figures figures = make_figures(result);
  EXPECT_NE(make_findings(result.settings, figures)[0].find("One seed does not say how sure"),
            std::string::npos);
}

TEST(Recommendation, ThereIsNoneWithoutAnythingSure) {
  StudyResult result = result_of(8, {});
  result.reference.error = 10;
  EXPECT_FALSE(make_figures(result).recommendation.has_value());
}

}  // namespace
}  // namespace capcon
