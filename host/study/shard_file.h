#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/plan.h"

namespace capcon {

/// One of the parts that a study's jobs are shared out to: number `index` of `count`, from 1. The jobs are
/// numbered as plan_runs() has them, from 0; this part has those whose number is index - 1 modulo count.
struct Shard {
  std::uint32_t index = 1;
  std::uint32_t count = 1;

  /// "2/4". InputError for anything else.
  static Shard parse(const std::string& text);
  std::string str() const;
  /// Its jobs.
  std::vector<PlannedRun> jobs(const std::vector<PlannedRun>& plan) const;
};

/// A shard.json: what a shard is of.
struct ShardFile {
  Shard shard;
  std::string hash;         ///< shard_hash()
  nlohmann::json settings;  ///< what settings_from_json() takes, and "version"
  nlohmann::json device;
};

/// InputError where it is none.
ShardFile read_shard_file(const std::filesystem::path& file);

}  // namespace capcon
