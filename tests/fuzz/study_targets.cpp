// What a study goes on from, and what a device's cache keeps.
#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "base/sealed.h"
#include "fuzz/files.h"
#include "fuzz/target.h"
#include "study/close_up_facts.h"
#include "study/merge.h"
#include "study/regression.h"
#include "study/run_record.h"
#include "study/shard_file.h"
#include "study/study_file.h"

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

void read_kept_study(std::string_view bytes) {
  const MemoryFile input(bytes);
  const StudyFile study = read_study_file(input.path());
  const StudySettings& s = study.result.settings;
  require(s.width >= 1 && s.height >= 1 && s.seeds >= 1, "a study has pixels and seeds");
  require(!s.samplers.empty() && !s.samples.empty(), "a study has samplers and counts");
  for (const std::uint32_t n : s.samples) require(n >= 1, "a run has samples");
  require(study.result.reference.error >= 0, "an error is 0 or more");
  (void)study.result.device.value("name", "");
  const StudySettings again = settings_from_json(to_json(s));
  require(again.samplers == s.samplers && again.samples == s.samples, "what is written is read again");
}

void read_study_shard(std::string_view bytes) {
  const MemoryFile input(bytes);
  const ShardFile part = read_shard_file(input.path());
  require(part.shard.index >= 1 && part.shard.index <= part.shard.count, "a shard is one of its number");
  require(Shard::parse(part.shard.str()).count == part.shard.count, "what is written is read again");
  (void)part.device.value("name", "");
  const StudySettings s = settings_from_json(part.settings);
  require(double(s.samplers.size()) * double(s.samples.size()) * s.seeds <= 1e7, "jobs have room");
}

void read_close_up_facts(std::string_view bytes) {
  CloseUpFacts facts;
  try {
    facts = parse_close_up_facts(bytes);
  } catch (const std::exception&) {  // then a report does without them
    throw InputError("these are no close-ups");
  }
  const CloseUps& c = facts.close_ups;
  require(c.region.x >= 0 && c.region.y >= 0 && c.region.width >= 1 && c.region.height >= 1, "a region");
  require(c.exposure > 0 && std::isfinite(c.exposure) && std::isfinite(1 / c.exposure), "an exposure");
  require(!c.samples.empty() && c.views.size() <= 1000, "a report has counts to show, and room");
}

void read_sealed(std::string_view bytes) {
  const auto data = unsealed(kMagic, bytes);
  require(!data || sealed(kMagic, *data) == bytes, "only what was sealed is opened");
  const std::string whole = sealed(kMagic, bytes);
  require(unsealed(kMagic, whole) == bytes, "what was sealed is opened");
  require(!unsealed(kMagic, std::string_view(whole).substr(0, whole.size() - 1)), "what is cut short is not");
}

}  // namespace capcon::fuzz
