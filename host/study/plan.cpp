#include "study/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"

namespace capcon {

std::vector<PlannedRun> plan_runs(const StudySettings& settings) {
  std::vector<PlannedRun> runs;
  for (std::uint32_t seed = 1; seed <= settings.seeds; ++seed) {
    for (const std::uint32_t samples : settings.samples) {
      std::vector<std::string> order = settings.samplers;
      for (std::size_t i = order.size(); i > 1; --i) {  // Fisher and Yates
        const auto j = static_cast<std::size_t>(uniform64(seed, samples, i) * static_cast<double>(i));
        std::swap(order[i - 1], order[j]);
      }
      for (const std::string& sampler : order) runs.push_back({sampler, samples, seed});
    }
  }
  return runs;
}

namespace {

/// What make_sampler calls it.
const std::string& sampler_of(const StudySettings& settings, const std::string& name) {
  const auto file = settings.point_files.find(name);
  return file == settings.point_files.end() ? name : file->second.sampler;
}

DirectLightingJob direct_job(const StudySettings& settings, std::uint32_t image, std::uint32_t points,
                             const std::string& sampler, std::uint32_t seed) {
  DirectLightingJob job;
  job.sampler = sampler_of(settings, sampler);
  job.image_samples = image;
  job.integrator_samples = points;
  job.seed = seed;
  job.position = settings.position;
  return job;
}

/// `variant` makes the light paths; what happens in the pixel is the same for all.
GlobalIlluminationJob global_illumination_job(const StudySettings& settings, const Variant& variant,
                                              std::uint32_t sets, std::uint32_t seed) {
  GlobalIlluminationJob job;
  job.direct = direct_job(settings, 1, 1, kReferenceSampler, seed);
  job.sampler = sampler_of(settings, variant.sampler);
  job.partition = variant.partition;
  job.paths = variant.factor * settings.paths;
  job.sets = sets;
  job.gather = kGatherRays;
  job.clamping = settings.clamping;
  job.limit = settings.limit;
  job.only_indirect = true;
  check_job(job);
  return job;
}

}  // namespace

Job make_job(const StudySettings& settings, const PlannedRun& run) {
  if (settings.integral == Integral::ambient_occlusion)
    return AmbientOcclusionJob{settings.radius, sampler_of(settings, run.sampler), run.samples, run.seed,
                               settings.position};
  if (settings.integral == Integral::direct)
    return direct_job(settings, 1, run.samples, run.sampler, run.seed);
  const Variant variant = parse_variant(run.sampler);
  if (settings.integral == Integral::global_illumination)
    return global_illumination_job(settings, variant, run.samples, run.seed);
  DirectLightingJob job = direct_job(settings, run.samples, variant.factor * settings.combined / run.samples,
                                     variant.sampler, run.seed);
  job.partition = variant.partition;
  return job;
}

Job make_reference_job(const StudySettings& settings, std::uint32_t group) {
  const std::uint32_t seed = kReferenceSeed + group;
  if (settings.integral == Integral::ambient_occlusion)
    return AmbientOcclusionJob{settings.radius, kReferenceSampler, settings.reference_samples, seed,
                               settings.position};
  if (settings.integral == Integral::global_illumination)
    return global_illumination_job(settings, {kReferenceSampler}, settings.reference_samples, seed);
  // At pixel centres one image sample is all there is; else as many as points keep the same total.
  const bool centre = settings.position == PixelPosition::centre;
  const std::uint32_t points =
      centre ? settings.reference_samples : std::max(1u, settings.reference_samples / 64);
  return direct_job(settings, centre ? 1 : settings.reference_samples / points, points, kReferenceSampler,
                    seed);
}

std::string_view clamping_name(Clamping clamping) {
  return clamping == Clamping::none ? "none" : clamping == Clamping::clamp ? "clamp" : "compensate";
}

nlohmann::json to_json(const StudySettings& s) {
  nlohmann::json json = {
      {"integral", words_of(s.integral).slug},
      {"combined", s.combined},
      {"pixel_samples", s.position == PixelPosition::centre ? "centre" : "jittered"},
      {"scene", s.scene},
      {"scene_fingerprint", fmt::format("{:016x}", s.scene_fingerprint)},
      {"points_fingerprint", fmt::format("{:016x}", s.points_fingerprint)},
      {"unique_triangles", s.unique_triangles},
      {"instanced_triangles", s.instanced_triangles},
      {"width", s.width},
      {"height", s.height},
      // JSON has no infinity.
      {"radius", std::isfinite(s.radius) ? nlohmann::json(s.radius) : nlohmann::json("infinite")},
      {"samplers", s.samplers},
      {"samples", s.samples},
      {"seeds", s.seeds},
      {"reference_samples", s.reference_samples},
      {"reference_groups", s.reference_groups},
      {"close_ups", s.close_ups},
      {"command", s.command}};
  for (const auto& [name, file] : s.point_files) {
    json["point_files"][name] = {{"sampler", file.sampler},
                                 {"fingerprint", fmt::format("{:016x}", file.fingerprint)}};
  }
  if (s.integral == Integral::global_illumination) {
    json["paths"] = s.paths;
    json["limit"] = s.limit;
    json["gather"] = kGatherRays;
    json["clamping"] = clamping_name(s.clamping);
  }
  return json;
}

std::string settings_hash(const StudySettings& settings, const nlohmann::json& device) {
  nlohmann::json relevant = to_json(settings);
  for (const char* free : {"samplers", "samples", "seeds", "close_ups", "command"}) relevant.erase(free);
  relevant["device"] = device;
  relevant["version"] = version();
  return fmt::format("{:016x}", fnv1a64(relevant.dump()));
}

std::string count_label(const StudySettings& settings, std::uint32_t samples) {
  return settings.integral == Integral::splitting ? fmt::format("{}x{}", samples, settings.combined / samples)
                                                  : fmt::format("{}", samples);
}

std::vector<std::uint32_t> parse_samples(const std::string& text) {
  const auto fail = [&] {
    return InputError(fmt::format(
        "\"{}\" is no list of sample counts; write single counts and doubling ranges like 1,2,4..256", text));
  };
  const auto number = [&](std::string_view part) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    constexpr std::uint32_t kMost = 1u << 20;
    if (error != std::errc() || end != part.data() + part.size() || value == 0 || value > kMost) throw fail();
    return value;
  };
  std::set<std::uint32_t> counts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    const std::size_t dots = part.find("..");
    if (dots == std::string_view::npos) {
      counts.insert(number(part));
      continue;
    }
    const std::uint32_t last = number(part.substr(dots + 2));
    const std::uint32_t first = number(part.substr(0, dots));
    if (first > last) throw fail();
    for (std::uint32_t n = first; n <= last; n *= 2) counts.insert(n);
  }
  return {counts.begin(), counts.end()};
}

}  // namespace capcon
