#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/job.h"
#include "study/integral.h"

namespace capcon {

/// What a study is about; a plain value.
struct StudySettings {
  Integral integral = Integral::ambient_occlusion;
  std::string scene;  ///< as given or shipped: for the report
  std::uint64_t scene_fingerprint = 0;
  std::uint64_t points_fingerprint = 0;  ///< of what the samplers make: tile sets change
  std::uint64_t unique_triangles = 0;
  std::uint64_t instanced_triangles = 0;
  int width = 0;
  int height = 0;
  double radius = 0;                               ///< of ambient occlusion
  std::uint32_t combined = 16;                     ///< splitting: N, points a pixel
  std::uint32_t paths = 128;                       ///< global illumination: N, light paths a set
  Clamping clamping = Clamping::compensate;        ///< of the geometry term
  double limit = 0;                                ///< of the geometry term; 0: by the scene's size
  PixelPosition position = PixelPosition::centre;  ///< of image samples
  std::vector<std::string> samplers;
  /// Of samplers that are files of points ("file:mine.txt"): by what the study calls them ("mine") what they
  /// are, and a hash of the file.
  struct PointFile {
    std::string sampler;
    std::uint64_t fingerprint = 0;
  };
  std::map<std::string, PointFile> point_files;
  std::vector<std::uint32_t> samples = {
      1, 2, 4, 8, 16, 32, 64, 128, 256};   ///< splitting: P, divisors of N; global illumination: S
  std::uint32_t seeds = 8;                 ///< 1 ... seeds
  std::uint32_t reference_samples = 1024;  ///< of each group, at each pixel; or sets
  std::uint32_t reference_groups = 4;
  bool close_ups = true;
  std::string command;  ///< for the report
};

/// One measurement of the study.
struct PlannedRun {
  std::string sampler;  ///< has_variants(): a variant, see parse_variant()
  std::uint32_t samples = 1;
  std::uint32_t seed = 1;

  bool operator==(const PlannedRun&) const = default;
};

/// Every (sampler, samples, seed) once, seeds outermost, then samples, then samplers in an order shuffled
/// anew for each of these by hash: a machine that slows down or warms up in the course of a study does so for
/// all samplers alike.
std::vector<PlannedRun> plan_runs(const StudySettings& settings);

/// With image samples at pixel centres the error is that of the integral alone. Of global illumination the
/// light paths are the sampler's; compensation rays are kReferenceSampler's for all, so that they add the
/// same noise.
Job make_job(const StudySettings& settings, const PlannedRun& run);

/// Compensation rays a set of a study of global illumination: noise that is the same for all samplers is kept
/// small beside what they differ in.
inline constexpr std::uint32_t kGatherRays = 4;

/// The reference's sampler, and the seed of its group: far from those of the runs.
inline constexpr const char* kReferenceSampler = "sobol-owen";
inline constexpr std::uint32_t kReferenceSeed = 0x52454600;
Job make_reference_job(const StudySettings& settings, std::uint32_t group);

/// As the command line has it.
std::string_view clamping_name(Clamping clamping);

/// All settings, as reports and headers show them.
nlohmann::json to_json(const StudySettings& settings);

/// Measurements with equal hashes may be laid together: same scene, size, radius, reference, device and
/// program. Samplers, samples and seeds do not enter, so a study can be extended.
std::string settings_hash(const StudySettings& settings, const nlohmann::json& device);

/// How tables name a count: "16", or "4x4" of a study of splitting.
std::string count_label(const StudySettings& settings, std::uint32_t samples);

/// "1,2,4..256": single counts and doubling ranges. InputError for anything else, for zero, or nothing.
std::vector<std::uint32_t> parse_samples(const std::string& text);

}  // namespace capcon
