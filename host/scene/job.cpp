#include "scene/job.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace capcon {

bool can_be_shared(const Job& job) {
  return !std::holds_alternative<PathTracingJob>(job);
}

Job with_share(Job job, const SampleShare& share) {
  if (auto* occlusion = std::get_if<AmbientOcclusionJob>(&job)) occlusion->share = share;
  if (auto* direct = std::get_if<DirectLightingJob>(&job)) direct->share = share;
  if (auto* igi = std::get_if<GlobalIlluminationJob>(&job)) igi->direct.share = share;
  return job;
}

PixelPosition position_of(const Job& job) {
  if (const auto* igi = std::get_if<GlobalIlluminationJob>(&job)) return igi->direct.position;
  if (const auto* direct = std::get_if<DirectLightingJob>(&job)) return direct->position;
  if (const auto* path = std::get_if<PathTracingJob>(&job)) return path->position;
  return std::get<AmbientOcclusionJob>(job).position;
}

void check_job(const GlobalIlluminationJob& job) {
  const auto require = [](bool holds, const std::string& sentence) {
    if (!holds) throw InputError(sentence);
  };
  require(job.paths >= 1 && job.sets >= 1 && job.gather >= 1 && job.block >= 1,
          "paths, sets, gather rays and the block's side must each be at least 1");
  require(
      std::uint64_t(job.paths) * job.sets <= (1u << 20),
      fmt::format("{} sets of {} light paths are too many: at most 2^20 paths in all", job.sets, job.paths));
  require(job.gather <= (1u << 14),
          fmt::format("{} compensation rays a set are too many: at most 2^14", job.gather));
  require(job.limit >= 0 && std::isfinite(job.limit), "the limit of the geometry term must be above 0");
  const std::uint32_t pixels = job.block * job.block;
  require(job.sets % pixels == 0,
          fmt::format(
              "blocks of {0}x{0} pixels share the sets out: their number must be a multiple of {1}, not {2}",
              job.block, pixels, job.sets));
  if (job.direct.position == PixelPosition::centre) return;
  require(job.direct.image_samples % job.sets_a_pixel() == 0,
          fmt::format(
              "each jittered image sample uses one set, and all are used equally often: their number must "
              "be a multiple of {}, not {} (such as --split {}x4)",
              job.sets_a_pixel(), job.direct.image_samples, job.sets_a_pixel()));
}

bool needs_shading(const Job& job) {
  return !std::holds_alternative<AmbientOcclusionJob>(job);
}

void finish_shares(RenderResult& all) {
  for (std::size_t i = 0; i < all.sums.size(); ++i)
    all.image.pixels[i] = static_cast<float>(all.sums[i] / all.samples);
  all.sums.clear();
}

nlohmann::json to_json(const Timings& timings) {
  return {{"wall", timings.wall}, {"device", timings.device}};
}

}  // namespace capcon
