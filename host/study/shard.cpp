#include "study/shard.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "study/study_work.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// Finished jobs in the folders of other shards. They may be at work: what cannot be read does not count.
std::vector<PlannedRun> finished_elsewhere(const fs::path& study, const fs::path& own,
                                           const std::string& hash) {
  std::vector<PlannedRun> finished;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(shards_folder(study), ignored)) {
    const fs::path log = entry.path() / "runs.jsonl";
    if (entry.path() == own || !fs::exists(log, ignored)) continue;
    try {
      const RunFile file = read_runs(log);
      if (file.complete_bytes == 0 || file.header.at("settings_hash") != hash) continue;
      for (const RunRecord& record : file.records) finished.push_back(record.run);
    } catch (const InputError&) {
    }
  }
  return finished;
}

}  // namespace

fs::path shards_folder(const fs::path& study) {
  return study / "shards";
}

fs::path shard_folder(const fs::path& study, const Shard& shard) {
  return shards_folder(study) / fmt::format("{}-of-{}", shard.index, shard.count);
}

std::string study_key(const StudySettings& settings) {
  return settings_hash(settings, "any");
}

std::string shard_hash(const StudySettings& settings, const ReferenceImage& reference) {
  const auto& pixels = reference.image.pixels;
  const std::string_view bytes(reinterpret_cast<const char*>(pixels.data()), sizeof(float) * pixels.size());
  return settings_hash(settings, {{"reference", fmt::format("{:016x} {}", fnv1a64(bytes), reference.error)}});
}

StudyResult run_shard(const StudySettings& settings, const StudyDevice& device, const RunnerOptions& options,
                      const Shard& shard, const ReferenceImage& reference) {
  const fs::path folder = shard_folder(options.directory, shard);
  create_folder(folder);
  const std::string hash = shard_hash(settings, reference);
  RunLog log(folder / "runs.jsonl", study_header(settings, device.info, hash), options.fresh);
  write_file(folder / "shard.json", json({{"shard", shard.str()},
                                          {"settings", to_json(settings)},
                                          {"settings_hash", hash},
                                          {"device", device.info},
                                          {"version", version()},
                                          {"started", log.header().value("started", "")}})
                                            .dump(1) +
                                        "\n");
  std::vector<PlannedRun> jobs = shard.jobs(plan_runs(settings));
  if (!options.fresh) {
    const std::vector<PlannedRun> elsewhere = finished_elsewhere(options.directory, folder, hash);
    std::erase_if(jobs, [&](const PlannedRun& run) {
      return !log.find(run) && std::find(elsewhere.begin(), elsewhere.end(), run) != elsewhere.end();
    });
  }
  StudyResult result{
      settings, device.info, log.header().value("started", ""), std::string(version()), reference, {},
      0,        log.moved()};
  RunnerOptions own = options;
  own.directory = folder;
  const bool done =
      std::all_of(jobs.begin(), jobs.end(), [&](const PlannedRun& run) { return log.find(run); });
  StudyWork work(settings, device, own, &log, std::move(jobs));
  work.reference_was_there();
  std::optional<RunImages> images;
  if (keeps_images(settings.integral)) images = run_images(folder, hash);
  RunRecord by;
  by.process = fmt::format("{} on {}", shard.str(), host_name());
  if (!done && !options.shares_device) by.calibration_seconds = work.calibration_seconds();
  work.measure_all(result, images ? &*images : nullptr, by);
  return result;
}

}  // namespace capcon
