#include "study/regression.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "fake_device.h"
#include "folder.h"
#include "study/figures.h"
#include "study/runner.h"

namespace capcon {
namespace {

/// The study.json of a fake study; `worse` does with its points what half as many do.
nlohmann::json study(const Folder& folder, const std::string& worse = "", std::uint32_t seed_shift = 0) {
  StudySettings s = fake_settings();
  s.samples = {2, 8, 32};
  s.samplers = {"random", "sobol-owen", "capcon"};
  StudyDevice device = fake_device()(s.width, s.height);
  device.render = [inner = device.render, worse, seed_shift](const Job& any) {
    auto job = std::get<AmbientOcclusionJob>(any);
    if (job.sampler == worse) job.samples = std::max(1u, job.samples / 2);
    job.seed += seed_shift;
    return inner(job);
  };
  RunnerOptions options;
  options.directory = folder / ("study" + worse + std::to_string(seed_shift)).c_str();
  options.quiet = true;
  const StudyResult result = run_study(s, device, options);
  return to_json(result, make_figures(result));
}

std::string complaint(const Baseline& baseline, const nlohmann::json& settings) {
  try {
    check_comparable(baseline, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Regression, OfAStudyBesideItself) {
  const Folder folder;
  const nlohmann::json now = study(folder);
  write_file(folder / "b.json", now.dump());
  const Baseline baseline = read_baseline(folder / "b.json");
  EXPECT_EQ(complaint(baseline, now["settings"]), "");
  const Regression same = find_regressions(baseline, now);
  EXPECT_TRUE(same.worse.empty());
  EXPECT_EQ(same.compared + same.skipped, 6u);
  EXPECT_GE(same.compared, 5u);
}

TEST(Regression, NamesTheSamplerThatGotWorseAndNoOther) {
  const Folder folder;
  const Baseline baseline{"b.json", study(folder)};
  const nlohmann::json now = study(folder, "capcon");
  const Regression found = find_regressions(baseline, now);
  EXPECT_GE(found.worse.size(), 2u);
  for (const Worsening& w : found.worse) {
    EXPECT_EQ(w.sampler, "capcon");
    EXPECT_EQ(w.baseline, "sobol-owen");
    EXPECT_GT(w.factor, 1.1);  // about 2, where it was measured
    EXPECT_LT(w.factor, 2.6);
  }
  EXPECT_EQ(sentence(found.worse.back(), now).rfind("capcon: samples needed for the error of ", 0), 0u);
  // Got better: nothing to say.
  EXPECT_TRUE(find_regressions({"b.json", now}, baseline.json).worse.empty());
}

// Other seeds of the same samplers: as good.
TEST(Regression, ChanceIsNoRegression) {
  const Folder folder;
  const Baseline baseline{"b.json", study(folder)};
  EXPECT_LE(find_regressions(baseline, study(folder, "", 1000)).worse.size(), 1u);  // 1 in 40 each
}

nlohmann::json with(nlohmann::json study, double value, double half, int beyond = 0) {
  nlohmann::json& ratio = study["ratios"].front();
  ratio["equal_error_beyond"] = beyond;
  ratio["equal_error_samples"] = {{"value", value}, {"low", value / half}, {"high", value * half}};
  if (beyond != 0) ratio["equal_error_samples"] = {{"value", nullptr}, {"low", nullptr}, {"high", nullptr}};
  study["ratios"] = {ratio};
  return study;
}

TEST(Regression, TheIntervalOfTheDifferenceDecides) {
  const Folder folder;
  const nlohmann::json any = study(folder);  // of 2, 8 and 32 samples
  const auto worse = [&](const nlohmann::json& was, const nlohmann::json& is) {
    return find_regressions({"b.json", was}, is).worse.size();
  };
  // Half widths log 1.1 each: log 1.1 * sqrt 2 together, a factor of 1.1443.
  EXPECT_EQ(worse(with(any, 10, 1.1), with(any, 11.40, 1.1)), 0u);
  EXPECT_EQ(worse(with(any, 10, 1.1), with(any, 11.48, 1.1)), 1u);
  EXPECT_EQ(worse(with(any, 10, 1.1), with(any, 0, 0, 1)), 1u);
  EXPECT_EQ(worse(with(any, 30, 1.1), with(any, 0, 0, 1)), 0u);
  EXPECT_EQ(worse(with(any, 0, 0, -1), with(any, 2.1, 1.1)), 0u);
  EXPECT_EQ(worse(with(any, 0, 0, -1), with(any, 2.3, 1.1)), 1u);
  EXPECT_EQ(worse(with(any, 0, 0, -1), with(any, 0, 0, 1)), 1u);
  // Beyond then: the MSE at equal samples decides.
  const auto of_mse = [&](double value, double half) {
    nlohmann::json study = with(any, 0, 0, 1);
    study["ratios"].front()["mse_ratio"] = {{"value", value}, {"low", value / half}, {"high", value * half}};
    return study;
  };
  EXPECT_EQ(worse(of_mse(1.5, 1.1), of_mse(1.6, 1.1)), 0u);
  EXPECT_EQ(worse(of_mse(1.5, 1.1), of_mse(1.8, 1.1)), 1u);
  EXPECT_EQ(worse(of_mse(1.8, 1.1), of_mse(1.5, 1.1)), 0u);
  EXPECT_EQ(worse(with(any, 10, 1.1), with(any, 0, 0, -1)), 0u);
}

TEST(Regression, OtherScenesAndSettingsAreRefused) {
  const Folder folder;
  const Baseline baseline{"b.json", study(folder)};
  nlohmann::json settings = baseline.json["settings"];
  settings["points_fingerprint"] = "another";  // what is checked
  EXPECT_EQ(complaint(baseline, settings), "");
  for (const char* name : {"scene_fingerprint", "radius", "width", "samples", "seeds", "integral"}) {
    nlohmann::json other = settings;
    other[name] = 77;
    EXPECT_EQ(complaint(baseline, other).rfind(std::string("b.json: ") + name + " is ", 0), 0u)
        << complaint(baseline, other);
  }
  settings["samplers"] = {"random", "sobol-owen"};
  EXPECT_NE(complaint(baseline, settings).find("capcon is there and not in this study"), std::string::npos);
  for (const char* text : {"", "{}", "[1]", "{\"study\":\"direct\",\"settings\":{},\"ratios\":[]}"}) {
    write_file(folder / "wrong.json", text);
    EXPECT_THROW(read_baseline(folder / "wrong.json"), InputError) << text;
  }
}

}  // namespace
}  // namespace capcon
