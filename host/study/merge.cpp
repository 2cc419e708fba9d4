#include "study/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "study/shard.h"
#include "study/study_work.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What a shard left behind.
struct Part : ShardFile {
  fs::path folder;
  RunFile runs;
};

Part read_part(const fs::path& folder) {
  Part part{read_shard_file(folder / "shard.json"), folder, {}};
  std::error_code ignored;
  if (fs::exists(folder / "runs.jsonl", ignored)) part.runs = read_runs(folder / "runs.jsonl");
  // A shard that started anew with other settings may have ended before its first line.
  if (part.runs.complete_bytes > 0 && part.runs.header.at("settings_hash") != part.hash) part.runs = {};
  return part;
}

std::vector<Part> read_parts(const std::vector<fs::path>& folders, const std::optional<std::string>& only) {
  std::vector<Part> parts;
  for (const fs::path& study : folders) {
    std::error_code error;
    std::size_t found = 0;
    for (const auto& entry : fs::directory_iterator(shards_folder(study), error)) {
      if (!fs::exists(entry.path() / "shard.json", error)) continue;
      ++found;
      Part part = read_part(entry.path());
      if (!only || part.hash == *only) parts.push_back(std::move(part));
    }
    if (found == 0) {
      throw InputError(
          fmt::format("{}: there are no shards of a study; make them with capcon study ... --shard 1/4 -o {}",
                      study.string(), study.string()));
    }
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::tuple(a.shard.count, a.shard.index, a.folder) <
           std::tuple(b.shard.count, b.shard.index, b.folder);
  });
  return parts;
}

/// Samplers, counts and seeds may be those of a part of a study.
void check_same(const Part& a, const Part& b) {
  for (const auto& [name, value] : a.settings.items()) {
    static constexpr std::array kFree = {"samplers", "samples", "seeds", "close_ups", "command"};
    if (std::find(kFree.begin(), kFree.end(), name) != kFree.end()) continue;
    if (b.settings.contains(name) && b.settings[name] == value) continue;
    throw InputError(fmt::format("{} and {} are not of one study: {} is {} in one and {} in the other",
                                 a.folder.string(), b.folder.string(), name, value.dump(),
                                 b.settings.value(name, json()).dump()));
  }
  if (a.hash != b.hash) {
    throw InputError(fmt::format(
        "{} and {} measured against different reference images; make one first with --only-reference, copy "
        "shards/reference.exr to where each shard writes, and give their commands again",
        a.folder.string(), b.folder.string()));
  }
}

std::size_t jobs_of(const json& settings) {
  return settings.at("samplers").size() * settings.at("samples").size() *
         settings.at("seeds").get<std::size_t>();
}

/// The command of `part`, for another shard of as many.
std::string command_for(const Part& part, const Shard& shard) {
  const auto command = part.settings.at("command").get<std::string>();
  static const std::regex kOption("--shard[ =][0-9]+/[0-9]+");
  return std::regex_search(command, kOption) ? std::regex_replace(command, kOption, "--shard " + shard.str())
                                             : fmt::format("{} under mpirun", command);
}

[[noreturn]] void complain(const std::vector<PlannedRun>& plan, const std::vector<PlannedRun>& missing,
                           const Part& part) {
  std::map<std::uint32_t, std::size_t> by_shard;
  for (const PlannedRun& run : missing) {
    const auto number = static_cast<std::size_t>(std::find(plan.begin(), plan.end(), run) - plan.begin());
    ++by_shard[static_cast<std::uint32_t>(number % part.shard.count) + 1];
  }
  std::string which;
  for (const auto& [index, count] : by_shard) {
    const Shard shard{index, part.shard.count};
    which += fmt::format("{}{} of shard {} ({})", which.empty() ? "" : "; ", count, shard.str(),
                         command_for(part, shard));
  }
  throw Failure(fmt::format("{} of {} jobs are missing: {}", missing.size(), plan.size(), which));
}

/// The device of all, or the list of them.
json device_of(const std::vector<Part>& parts) {
  json devices = json::array();
  for (const Part& part : parts) {
    if (std::find(devices.begin(), devices.end(), part.device) == devices.end())
      devices.push_back(part.device);
  }
  if (devices.size() == 1) return devices[0];
  std::string names;
  for (const json& device : devices) names += (names.empty() ? "" : ", ") + device.value("name", "unknown");
  return {{"name", names}, {"devices", devices}};
}

/// The log is gone on with as by one process: runs that are there stay, those of other settings are moved
/// away.
void write_merged(const fs::path& out, StudyResult& result,
                  const std::map<const RunRecord*, const Part*>& from) {
  const std::string hash = merged_hash(result);
  create_folder(out);
  if (keeps_images(result.settings.integral)) {
    const RunImages images = run_images(out, hash);
    for (const auto& [record, part] : from) {
      if (auto image = run_images(part->folder, part->hash).read(record->run))
        images.write(record->run, *image);
    }
  }
  write_reference(out / "reference.exr", result.reference, result.settings, hash);
  json header = study_header(result.settings, result.device, hash);
  header["started"] = result.started;
  std::error_code ignored;
  if (!fs::exists(out / "runs.jsonl", ignored)) {
    std::string lines = header.dump() + '\n';
    for (const RunRecord& record : result.records) lines += to_json(record).dump() + '\n';
    write_file(out / "runs.jsonl", lines);
    return;
  }
  RunLog log(out / "runs.jsonl", header, false);
  result.moved = log.moved();
  for (RunRecord& record : result.records) {
    if (const RunRecord* there = log.find(record.run)) {
      record = *there;
    } else {
      log.append(record);
    }
  }
}

}  // namespace

std::string merged_hash(const StudyResult& merged) {
  return settings_hash(merged.settings, merged.device);
}

StudyResult merge_shards(const fs::path& out, const std::vector<fs::path>& folders,
                         const std::optional<std::string>& only) {
  const std::vector<Part> parts = read_parts(folders, only);
  if (parts.empty())
    throw Failure(fmt::format("{}: no shard of this study has begun", folders.front().string()));
  if (const json& made_by = parts.front().settings.at("version"); made_by != version()) {
    throw InputError(fmt::format("{}: was measured by capcon {}, and this is {}; merge with the same",
                                 parts.front().folder.string(), made_by.dump(), version()));
  }
  const Part* largest = &parts.front();
  for (const Part& part : parts) {
    check_same(parts.front(), part);
    if (jobs_of(part.settings) > jobs_of(largest->settings)) largest = &part;
  }
  StudyResult result{
      settings_from_json(largest->settings), device_of(parts), {}, std::string(version()), {}, {}, 0, {}};
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, std::pair<const RunRecord*, const Part*>>
      found;
  for (const Part& part : parts) {
    const std::string started = part.runs.header.is_object() ? part.runs.header.value("started", "") : "";
    if (!started.empty() && (result.started.empty() || started < result.started)) result.started = started;
    for (const RunRecord& r : part.runs.records)
      found.try_emplace({r.run.sampler, r.run.samples, r.run.seed}, &r, &part);
  }
  const std::vector<PlannedRun> plan = plan_runs(result.settings);
  std::vector<PlannedRun> missing;
  std::map<const RunRecord*, const Part*> from;
  for (const PlannedRun& run : plan) {
    const auto it = found.find({run.sampler, run.samples, run.seed});
    if (it == found.end()) {
      missing.push_back(run);
      continue;
    }
    result.records.push_back(*it->second.first);
    from.insert(it->second);
  }
  if (!missing.empty()) complain(plan, missing, *largest);
  for (const fs::path& study : folders) {
    auto reference = read_reference(shards_folder(study) / "reference.exr", study_key(result.settings));
    if (reference && shard_hash(result.settings, *reference) == largest->hash) {
      result.reference = std::move(*reference);
      break;
    }
  }
  if (result.reference.image.pixels.empty()) {
    throw InputError(fmt::format("{}: the reference image of the shards is missing or another; copy it there",
                                 (shards_folder(folders.front()) / "reference.exr").string()));
  }
  write_merged(out, result, from);
  return result;
}

}  // namespace capcon
