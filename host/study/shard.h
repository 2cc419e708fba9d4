#pragma once

#include <optional>
#include <string>

#include "distributed/ranks.h"
#include "study/runner.h"
#include "study/shard_file.h"

namespace capcon {

/// What shards keep lies in `study`/shards: reference.exr, which all have in common, and a folder for each
/// ("2-of-4") that nobody else writes to, so that network file systems need no locks.
std::filesystem::path shards_folder(const std::filesystem::path& study);
std::filesystem::path shard_folder(const std::filesystem::path& study, const Shard& shard);

/// What all shards of one study have in common, as settings_hash(), but that the device may be any.
std::string study_key(const StudySettings& settings);
/// The same, and that they measure against the same reference image.
std::string shard_hash(const StudySettings& settings, const ReferenceImage& reference);

/// The reference image that all shards measure against: the one in shards_folder(), if it is this study's;
/// else it is made and put there, unless another was quicker: then that one. Of several ranks each renders
/// its share of the groups, and all get the same bits.
ReferenceImage shared_reference(const StudySettings& settings, const StudyDevice& device,
                                const RunnerOptions& options, const Ranks& ranks);

/// Measures a shard's jobs against that image, or goes on with what is in its folder; jobs that are finished
/// in any other shard's folder are left out. Each new run bears the time that
/// StudyWork::calibration_seconds() took here. options.directory: the study's. The result has this shard's
/// own records alone.
StudyResult run_shard(const StudySettings& settings, const StudyDevice& device, const RunnerOptions& options,
                      const Shard& shard, const ReferenceImage& reference);

}  // namespace capcon
