#include "study/shard_file.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "base/error.h"
#include "base/file.h"
#include "study/merge.h"
#include "study/run_record.h"

namespace capcon {
namespace {

constexpr double kMostJobs = 1e7;

}  // namespace

Shard Shard::parse(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    if (second.ec == std::errc() && second.ptr == end && shard.index >= 1 && shard.index <= shard.count)
      return shard;
  }
  throw InputError(
      fmt::format("--shard {}: must be i/n, number i of n parts, from 1/n to n/n, such as 2/4", text));
}

std::string Shard::str() const {
  return fmt::format("{}/{}", index, count);
}

std::vector<PlannedRun> Shard::jobs(const std::vector<PlannedRun>& plan) const {
  std::vector<PlannedRun> mine;
  for (std::size_t i = index - 1; i < plan.size(); i += count) mine.push_back(plan[i]);
  return mine;
}

ShardFile read_shard_file(const std::filesystem::path& file) {
  try {
    const nlohmann::json json = parse_study_json(read_file(file));
    ShardFile part{Shard::parse(json.at("shard").get<std::string>()),
                   json.at("settings_hash").get<std::string>(), json.at("settings"), json.at("device")};
    part.settings["version"] = json.at("version");
    const StudySettings settings = settings_from_json(part.settings);
    const double jobs = double(settings.samplers.size()) * double(settings.samples.size()) * settings.seeds;
    const bool fits = jobs <= kMostJobs;  // before they are written out
    if (!fits || !part.device.is_object() ||
        (part.device.contains("name") && !part.device["name"].is_string()))
      throw std::out_of_range("jobs or device");
    return part;
  } catch (const std::exception&) {
    throw InputError(SourcePlace{file.string(), 0, 0},
                     "this is not a shard of a study; remove its folder, and do its jobs again");
  }
}

}  // namespace capcon
