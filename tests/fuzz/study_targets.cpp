// What a study goes on from, and what a device's cache keeps.
#include <cmath>

#include "base/hash.h"
#include "base/sealed.h"
#include "fuzz/files.h"
#include "fuzz/target.h"
#include "study/regression.h"
#include "study/run_record.h"

namespace capcon::fuzz {
using nlohmann::json;

namespace {

constexpr std::string_view kMagic = "capcon pipelines 1";

std::string text_of(const RunFile& file) {
  std::string text = file.header.dump() + '\n';
  for (const RunRecord& record : file.records) text += to_json(record).dump() + '\n';
  return text;
}

}  // namespace

void read_study_runs(std::string_view bytes) {
  const MemoryFile input(bytes);
  const RunFile file = read_runs(input.path());
  require(file.complete_bytes <= bytes.size(), "no more lines than the file has");
  if (file.complete_bytes == 0) return;
  require(!file.header.at("settings_hash").get<std::string>().empty(), "a header has its hash");
  (void)file.header.value("started", "");
  for (const RunRecord& r : file.records) {
    require(r.run.samples >= 1 && !r.run.sampler.empty(), "a run has samples of a sampler");
    for (const double value : {r.mse, r.mse_trimmed, r.relmse, r.mse_coarse, r.device_seconds, r.wall_seconds,
                               r.point_generation_seconds})
      require(std::isfinite(value) && value >= 0, "errors and times are finite, 0 or more");
    for (const auto* seconds : {&r.timings.wall, &r.timings.device})
      for (const auto& [stage, value] : *seconds) require(std::isfinite(value), "times are finite");
  }
  const std::string text = text_of(file);
  const MemoryFile again(text);
  require(text_of(read_runs(again.path())) == text, "what is written is read again");
}

void read_study_baseline(std::string_view bytes) {
  const MemoryFile input(bytes);
  const Baseline baseline = read_baseline(input.path());
  const Regression same = find_regressions(baseline, baseline.json);
  require(same.worse.empty(), "nothing is worse than itself");
  require(same.compared + same.skipped <= baseline.json.at("ratios").size(),
          "no more figures than there are");
  json settings = baseline.json.at("settings");
  if (!settings.contains("seeds")) settings["seeds"] = 2;
  check_comparable(baseline, settings);
}

void read_sealed(std::string_view bytes) {
  const auto data = unsealed(kMagic, bytes);
  require(!data || sealed(kMagic, *data) == bytes, "only what was sealed is opened");
  const std::string whole = sealed(kMagic, bytes);
  require(unsealed(kMagic, whole) == bytes, "what was sealed is opened");
  require(!unsealed(kMagic, std::string_view(whole).substr(0, whole.size() - 1)), "what is cut short is not");
}

}  // namespace capcon::fuzz
