#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "study/runner.h"

namespace capcon {

/// Lays the shards of one study together: a study's folder, `out`, gets runs.jsonl, reference.exr and images
/// as one process would have written them; where all devices are the same that process can go on with them.
/// Each record says which process measured it.
///
/// `folders` hold shards (shards/2-of-4); of those that plan different numbers of jobs (more seeds) the
/// largest plan counts. With `only`, the shard_hash() of a study, others are passed over. InputError where
/// there are no shards, or where they are not of one study: one sentence names what differs. Failure where
/// jobs are missing: it says how many, of which shard, and the command that does them.
StudyResult merge_shards(const std::filesystem::path& out, const std::vector<std::filesystem::path>& folders,
                         const std::optional<std::string>& only = {});

/// The hash that a merged study's runs and images have.
std::string merged_hash(const StudyResult& merged);

/// What to_json(StudySettings) gave. An exception of the JSON library, std::out_of_range or InputError where
/// it is not that.
StudySettings settings_from_json(const nlohmann::json& json);

}  // namespace capcon
