#include "study/overlay.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "fake_device.h"
#include "folder.h"
#include "study/study.h"

namespace capcon {
namespace {

/// A study of `s` in `folder`, on a machine that takes `slowness` times as long, with `noise` times the
/// deviation.
KeptStudy measured(const std::filesystem::path& folder, const StudySettings& s, double slowness,
                   double noise) {
  RunnerOptions options;
  options.directory = folder;
  options.quiet = true;
  const MakeStudyDevice usual = fake_device();
  study_report(
      s,
      [&](int width, int height) {
        const StudyDevice device = usual(width, height);
        return StudyDevice{[=](const Job& job) {
                             RenderResult result = device.render(job);
                             for (auto& [stage, seconds] : result.timings.device) seconds *= slowness;
                             for (int y = 0; y < height; ++y) {
                               for (int x = 0; x < width; ++x) {
                                 float& v = result.image.at(x, y, 0);
                                 const double truth = fake_truth(x, y, width, height);
                                 v = static_cast<float>(truth + noise * (v - truth));
                               }
                             }
                             return result;
                           },
                           {{"name", slowness == 1 ? "fast" : "slow"}, {"driver", "1.0"}}};
      },
      options);
  return read_kept_study(folder);
}

StudySettings settings() {
  StudySettings s = fake_settings();
  s.samples = {4, 16, 64};
  s.seeds = 4;
  return s;
}

TEST(Overlay, TellsASlowMachineFromASamplerThatErrsMore) {
  const Folder folder;
  const KeptStudy first = measured(folder / "a", settings(), 1, 1);
  StudySettings more = settings();
  more.seeds = 5;  // what both have counts
  const KeptStudy slow = measured(folder / "b", more, 2.5, 1);
  const Overlay o = make_overlay({first, slow}, {"fast", "slow"});
  EXPECT_EQ(o.seeds, 4u);
  ASSERT_EQ(o.beside.size(), 1u);
  EXPECT_TRUE(o.beside[0].same_errors);
  EXPECT_EQ(o.beside[0].ratios.size(), 4u * 3);
  for (const Ratio& r : o.beside[0].ratios) {
    EXPECT_NEAR(r.mse.value, 1, 1e-3) << r.sampler;  // the references differ a little
    EXPECT_NEAR(r.equal_error_time.value, 2.5, 0.02) << r.sampler << r.samples;
  }
  EXPECT_NE(make_findings(o)[0].find("2.5"), std::string::npos) << make_findings(o)[0];
  EXPECT_NE(make_findings(o)[0].find("it is slower"), std::string::npos);

  // Twice the variance: about 1.74 times the samples, by the law of n^-1.25 of this sampler, and as much more
  // time.
  const KeptStudy noisy = measured(folder / "c", settings(), 1, std::sqrt(2));
  const Overlay p = make_overlay({first, noisy}, {"before", "after"});
  EXPECT_FALSE(p.beside[0].same_errors);
  const Ratio* r = p.ratio(p.beside[0], "capcon", 16);
  ASSERT_NE(r, nullptr);
  EXPECT_NEAR(r->mse.value, 2, 0.01);
  EXPECT_NEAR(r->equal_error.value / 16, std::pow(2, 1 / 1.25), 0.1);
  EXPECT_NEAR(r->equal_error_time.value, std::pow(2, 1 / 1.25), 0.1);
  EXPECT_TRUE(r->mse.above(1));
  const std::string html = html_report(p);
  EXPECT_NE(html.find("capcon @ after"), std::string::npos);
  EXPECT_NE(html.find("after-beside-before.csv"), std::string::npos);
  EXPECT_LT(html.size(), 3'000'000u);
  EXPECT_EQ(to_json(p).at("beside").at(0).at("ratios").size(), 12u);
}

TEST(Overlay, NamesWhatDiffers) {
  const Folder folder;
  const KeptStudy first = measured(folder / "a", settings(), 1, 1);
  StudySettings other = settings();
  other.reference_samples = 8192;
  const Overlay o = make_overlay({first, measured(folder / "b", other, 3, 1)}, {});
  std::map<std::string, std::vector<std::string>> found;
  for (const Difference& d : differences(o)) found[d.name] = d.values;
  EXPECT_EQ(found["device name"], (std::vector<std::string>{"fast", "slow"}));
  EXPECT_EQ(found["samples of each reference group"], (std::vector<std::string>{"4096", "8192"}));
  EXPECT_FALSE(found.contains("device driver"));
  EXPECT_FALSE(found.contains("width"));
}

TEST(Overlay, RefusesWhatCannotBeCompared) {
  const Folder folder;
  const KeptStudy first = measured(folder / "a", settings(), 1, 1);
  const auto why = [&](const std::function<void(StudySettings&)>& change) -> std::string {
    KeptStudy second = first;
    second.folder = "other";
    change(second.result.settings);
    try {
      make_overlay({first, second}, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why([](StudySettings&) {}), "");
  EXPECT_NE(why([](StudySettings& s) { s.width = 41; }).find("width is 40 in one and 41 in the other"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) { s.radius = 3; }).find("radius is 2.0 in one and 3.0"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) { s.integral = Integral::direct; }).find("the study is"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) {
              s.scene_fingerprint = 5;
              s.scene = "b";
            }).find("the scene is fake <scene> in one and b"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) { s.scene_fingerprint = 5; }).find("what is in fake <scene>"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) { s.samplers = {"x"}; }).find("no sampler in common"),
            std::string::npos);
  EXPECT_NE(why([](StudySettings& s) { s.samples = {5}; }).find("no number of samples in common"),
            std::string::npos);
  EXPECT_THROW(make_overlay({first, first}, {"one"}), InputError);
  EXPECT_THROW(make_overlay({first, first}, {"one", "one"}), InputError);
  EXPECT_THROW(make_overlay({first, first}, {"one", "two"}, {"halton"}), InputError);
}

}  // namespace
}  // namespace capcon
