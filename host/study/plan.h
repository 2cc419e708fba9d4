#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/job.h"

namespace capcon {

/// What a study of ambient occlusion is about; a plain value.
struct StudySettings {
  std::string scene;  ///< as given or shipped: for the report
  std::uint64_t scene_fingerprint = 0;
  std::uint64_t points_fingerprint = 0;  ///< of what the samplers make: tile sets change
  std::uint64_t unique_triangles = 0;
  std::uint64_t instanced_triangles = 0;
  int width = 0;
  int height = 0;
  double radius = 0;
  std::vector<std::string> samplers;
  std::vector<std::uint32_t> samples = {1, 2, 4, 8, 16, 32, 64, 128, 256};
  std::uint32_t seeds = 8;                 ///< 1 ... seeds
  std::uint32_t reference_samples = 1024;  ///< of each group, at each pixel
  std::uint32_t reference_groups = 4;
  bool close_ups = true;
  std::string command;  ///< for the report
};

/// One measurement of the study.
struct PlannedRun {
  std::string sampler;
  std::uint32_t samples = 1;
  std::uint32_t seed = 1;

  bool operator==(const PlannedRun&) const = default;
};

/// Every (sampler, samples, seed) once, seeds outermost, then samples, then samplers in an order shuffled
/// anew for each of these by hash: a machine that slows down or warms up in the course of a study does so for
/// all samplers alike.
std::vector<PlannedRun> plan_runs(const StudySettings& settings);

/// Image samples at pixel centres: the error is that of the occlusion integral alone.
AmbientOcclusionJob make_job(const StudySettings& settings, const PlannedRun& run);

/// The reference's sampler, and the seed of its group: far from those of the runs.
inline constexpr const char* kReferenceSampler = "sobol-owen";
inline constexpr std::uint32_t kReferenceSeed = 0x52454600;
AmbientOcclusionJob make_reference_job(const StudySettings& settings, std::uint32_t group);

/// All settings, as reports and headers show them.
nlohmann::json to_json(const StudySettings& settings);

/// Measurements with equal hashes may be laid together: same scene, size, radius, reference, device and
/// program. Samplers, samples and seeds do not enter, so a study can be extended.
std::string settings_hash(const StudySettings& settings, const nlohmann::json& device);

/// "1,2,4..256": single counts and doubling ranges. InputError for anything else, for zero, or nothing.
std::vector<std::uint32_t> parse_samples(const std::string& text);

}  // namespace capcon
