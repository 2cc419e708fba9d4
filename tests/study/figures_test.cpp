#include "study/figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fake_device.h"
#include "study/findings.h"
#include "study/format.h"
#include "study/table.h"

namespace capcon {
namespace {

/// Runs that follow the laws exactly but for a factor that differs from seed to seed, alike for all samplers.
StudyResult exact_study(const StudySettings& settings, double reference_error = 1e-9) {
  StudyResult result;
  result.settings = settings;
  result.device = {{"name", "fake"}};
  result.reference.error = reference_error;
  for (const PlannedRun& run : plan_runs(settings)) {
    const FakeLaw law = fake_law(run.sampler);
    const double spread = std::exp(0.02 * (run.seed - (settings.seeds + 1) / 2.0));
    result.records.push_back(exact_run(run.sampler, run.samples, run.seed,
                                       spread * law.c * std::pow(run.samples, -law.p) + reference_error,
                                       law.seconds_per_sample * run.samples));
  }
  return result;
}

TEST(Figures, TakesTheReferencesErrorOff) {
  const StudyResult result = exact_study(fake_settings(), 1e-4);
  const Figures figures = make_figures(result);
  for (const Curve& curve : figures.curves) {
    for (const Cell& cell : curve.cells) {
      const FakeLaw law = fake_law(curve.sampler);
      const double truth = law.c * std::pow(cell.samples, -law.p);
      EXPECT_EQ(cell.sure, truth >= 3e-4 * 0.999) << curve.sampler << cell.samples;
      if (cell.sure) {
        EXPECT_NEAR(cell.mse.value / truth, 1, 1e-9);
      }
    }
  }
}

TEST(Figures, IntervalOfACellByHand) {
  const Figures figures = make_figures(exact_study(fake_settings()));
  const Cell& cell = *find_cell(*figures.curve("random"), 4);
  // Logarithms 0.02 (seed - 4.5): standard deviation 0.02 sqrt(6); t(7) = 2.364624.
  EXPECT_NEAR(std::log(cell.mse.high / cell.mse.value), 2.364624 * 0.02 * std::sqrt(6.0) / std::sqrt(8.0),
              1e-7);
  EXPECT_NEAR(cell.mse.value, 0.05, 1e-9);
  EXPECT_GT(cell.mean_mse, cell.mse.value);
  EXPECT_NEAR(cell.device_seconds.value, 4e-3, 1e-12);
  EXPECT_NEAR(cell.wall_seconds.value, 8e-3, 1e-12);
  EXPECT_NEAR(cell.wall_without_points.value, 6e-3, 1e-12);
  EXPECT_NEAR(cell.point_seconds, 2e-3, 1e-12);
}

TEST(Figures, SlopesAndRatiosOfPowerLaws) {
  const Figures figures = make_figures(exact_study(fake_settings()));
  EXPECT_NEAR(figures.curve("random")->slope.value, -1, 1e-7);
  EXPECT_NEAR(figures.curve("capcon")->slope.value, -1.25, 1e-6);
  EXPECT_NEAR(figures.curve("sobol-owen")->time_slope.value, -1.25, 1e-6);
  EXPECT_EQ(figures.curve("random")->slope_cells, 5u);
  const Ratio* r = figures.ratio("capcon", "sobol-xor", 16);
  ASSERT_TRUE(r);
  EXPECT_NEAR(r->mse.value, 0.5, 1e-6);
  EXPECT_NEAR(r->mse.high, 0.5, 1e-6);  // the seeds' common factor leaves the ratio
  EXPECT_NEAR(r->equal_error.value, 16 * std::pow(0.5, 1 / 1.25), 1e-5);
  EXPECT_NEAR(r->equal_time.value, 0.5, 1e-6);
  EXPECT_EQ(r->beyond, 0);
  // In the time of 16 sobol-owen samples capcon takes 32.
  EXPECT_NEAR(figures.ratio("capcon", "sobol-owen", 16)->equal_time.value, 0.5 * std::pow(2, -1.25), 1e-6);
  EXPECT_NEAR(figures.ratio("sobol-owen", "sobol-xor", 16)->equal_time.value, std::pow(2, 1.25), 1e-6);
}

TEST(Figures, NothingIsExtrapolated) {
  const Figures figures = make_figures(exact_study(fake_settings()));
  const Ratio* few = figures.ratio("capcon", "sobol-xor", 1);  // one sample of capcon is better already
  EXPECT_EQ(few->beyond, -1);
  EXPECT_TRUE(std::isnan(few->equal_error.value));
  EXPECT_EQ(figures.ratio("random", "sobol-xor", 64)->beyond, 1);
  EXPECT_TRUE(
      std::isnan(figures.ratio("capcon", "sobol-owen", 64)->equal_time.value));  // would need 128 samples
}

TEST(Figures, UnsureCellsEnterNoComparison) {
  const Figures figures = make_figures(exact_study(fake_settings(), 2e-3));
  EXPECT_FALSE(find_cell(*figures.curve("capcon"), 16)->sure);
  EXPECT_TRUE(std::isnan(figures.ratio("capcon", "sobol-xor", 32)->mse.value));
  EXPECT_NEAR(figures.curve("capcon")->slope.value, -1.25, 1e-6);
  EXPECT_EQ(figures.curve("capcon")->slope_cells, 2u);  // 4 and 8
  const std::string table = text_tables(exact_study(fake_settings(), 2e-3), figures);
  EXPECT_NE(table.find("unsure"), std::string::npos);
  EXPECT_NE(table.find("reference image's own error"), std::string::npos);
}

TEST(Figures, OneSeedGivesFiguresWithoutIntervals) {
  StudySettings s = fake_settings();
  s.seeds = 1;
  const Figures figures = make_figures(exact_study(s));
  const Ratio* r = figures.ratio("capcon", "sobol-xor", 16);
  EXPECT_NEAR(r->mse.value, 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(r->mse.low));
  const std::string table = text_tables(exact_study(s), figures);
  EXPECT_EQ(table.find("nan"), std::string::npos) << table;
  EXPECT_EQ(table.find("errs"), std::string::npos);
  EXPECT_NE(table.find("one seed only"), std::string::npos);
}

TEST(Figures, FindingsSayWhatTheFiguresSay) {
  const StudySettings s = fake_settings();
  const auto findings = make_findings(s, make_figures(exact_study(s)));
  EXPECT_EQ(findings[1],
            "capcon needs 36.8 (36.8–36.8) samples for the error of 64 sobol-xor samples and "
            "36.8 (36.8–36.8) for the error of 64 sobol-owen samples.");
  EXPECT_NE(findings[2].find("errs less than sobol-xor at 1 to 64 samples."), std::string::npos)
      << findings[2];
  // The other way round it must say so too.
  StudyResult swapped = exact_study(s);
  for (RunRecord& r : swapped.records) {
    if (r.run.sampler == "capcon") r.mse *= 4;
  }
  const auto worse = make_findings(s, make_figures(swapped));
  EXPECT_NE(worse[1].find("more than 64"), std::string::npos) << worse[1];
  EXPECT_NE(worse[2].find("errs more than sobol-xor at 1 to 64 samples."), std::string::npos) << worse[2];
}

TEST(Format, Numbers) {
  EXPECT_EQ(scientific(0.00297), "2.97e-3");
  EXPECT_EQ(scientific(NAN), "–");
  EXPECT_EQ(short_number(0.8123), "0.81");
  EXPECT_EQ(short_number(12.34), "12.3");
  EXPECT_EQ(short_number(99.97), "100");
  EXPECT_EQ(short_number(0.0123), "0.012");
  EXPECT_EQ(duration(0.00083), "830 µs");
  EXPECT_EQ(duration(1.416), "1.42 s");
  EXPECT_EQ(percent_around({1, 0.99, 1.01}), "±1.0 %");
  EXPECT_EQ(with_range({0.8, 0.7, 0.9}), "0.80 (0.70–0.90)");
  EXPECT_EQ(grouped(1602392), "1,602,392");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(enumerate({"1", "2", "3"}), "1, 2 and 3");
}

}  // namespace
}  // namespace capcon
