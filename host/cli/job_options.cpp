#include "cli/job_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "sampling/sampler.h"

namespace capcon::cli {
namespace {

constexpr std::uint32_t kMostSamples = 1u << 24;

Strategy strategy_of(const std::string& name) {
  if (name == "balance") return Strategy::balance;
  if (name == "lights") return Strategy::lights;
  return name == "bsdf" ? Strategy::bsdf : Strategy::power;
}

}  // namespace

std::pair<std::uint32_t, std::uint32_t> parse_split(const std::string& text) {
  std::uint32_t image = 0, integrator = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, image);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == 'x') {
    const auto second = std::from_chars(first.ptr + 1, end, integrator);
    if (second.ec == std::errc() && second.ptr == end && image > 0 && integrator > 0 &&
        std::uint64_t(image) * integrator <= kMostSamples)
      return {image, integrator};
  }
  throw InputError(fmt::format(
      "--split {}: must be PxI, image samples a pixel times integrator samples each, such as 4x16", text));
}

void JobOptions::add_to(CLI::App& verb) {
  verb.add_option("--integrator", integrator,
                  "ao: ambient occlusion, cosine-weighted; direct: light straight from the lights")
      ->capture_default_str()
      ->check(CLI::IsMember({"ao", "direct"}));
  verb.add_option(
          "--sampler", sampler,
          "Where sample points come from: random jittered sobol-xor sobol-owen ccvt capcon capcon-domain")
      ->capture_default_str();
  auto* count = verb.add_option("--samples", samples, "ao: occlusion rays a pixel; direct: as --split 1xN")
                    ->capture_default_str()
                    ->check(CLI::Range(1u, kMostSamples));
  verb.add_option(
          "--split", split,
          "PxI, direct: P image samples a pixel, each with I points on every light and I for the BSDF")
      ->excludes(count);
  verb.add_flag("--no-partition", no_partition,
                "Direct: the P sets of a pixel are sets of their own, not the parts of one");
  verb.add_option("--seed", seed, "Seed of everything random; the same seed gives the same bits")
      ->capture_default_str();
  verb.add_option("--radius", radius,
                  "ao: occluders farther away than this do not count (scene units; default inf)")
      ->check(CLI::PositiveNumber);
  verb.add_option("--strategy", strategy,
                  "Direct: how light and BSDF samples are combined: power, balance (heuristics); lights, "
                  "bsdf (alone)")
      ->capture_default_str()
      ->check(CLI::IsMember({"power", "balance", "lights", "bsdf"}));
  verb.add_option("--pixel-samples", position,
                  "centre: all image samples at the pixel's centre; jittered: each at its own place")
      ->capture_default_str()
      ->check(CLI::IsMember({"centre", "jittered"}));
  verb.add_option("--filter", filter,
                  "Direct, jittered: how places in a pixel weigh: box, gaussian (radius 1.5)")
      ->capture_default_str()
      ->check(CLI::IsMember({"box", "gaussian"}));
}

Job JobOptions::job() const {
  const PixelPosition place = position == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
  make_sampler(sampler, 1, 1);  // an unknown name is said before the work
  if (integrator == "ao") {
    if (!(radius > 0)) throw InputError("--radius must be above 0 (or inf)");
    if (!split.empty() || no_partition || filter != "box" || strategy != "power")
      throw InputError("--split, --no-partition, --filter and --strategy are for --integrator direct");
    return AmbientOcclusionJob{radius, sampler, samples, seed, place};
  }
  if (std::isfinite(radius)) throw InputError("--radius is for --integrator ao");
  if (filter != "box" && place == PixelPosition::centre)
    throw InputError("--filter gaussian places image samples: it goes with --pixel-samples jittered");
  DirectLightingJob job;
  job.sampler = sampler;
  std::tie(job.image_samples, job.integrator_samples) =
      split.empty() ? std::pair(1u, samples) : parse_split(split);
  job.seed = seed;
  job.position = place;
  job.filter = filter == "box" ? PixelFilter::box : PixelFilter::gaussian;
  job.strategy = strategy_of(strategy);
  job.partition = !no_partition;
  return job;
}

std::uint32_t JobOptions::samples_a_pixel() const {
  if (integrator == "ao" || split.empty()) return samples;
  const auto [image, points] = parse_split(split);
  return image * points;
}

std::string JobOptions::key() const {
  return fmt::format("{} {} {} {} {} {} {} {} {} {}", integrator, sampler, samples, split, seed, radius,
                     position, filter, strategy, no_partition);
}

void describe(const JobOptions& o, Attributes& a) {
  a["samplesPerPixel"] = static_cast<int>(o.samples_a_pixel());
  a["integrator"] = o.integrator;
  a["sampler"] = o.sampler;
  a["seed"] = static_cast<int>(o.seed);
  a["pixelSamples"] = o.position;
  if (o.integrator == "ao") {
    a["radius"] = static_cast<float>(o.radius);
    return;
  }
  a["split"] = o.split.empty() ? fmt::format("1x{}", o.samples) : o.split;
  a["strategy"] = o.strategy;
  a["filter"] = o.filter;
  a["partition"] = o.no_partition ? "none" : "parts of one set";
}

void describe(const JobOptions& o, nlohmann::ordered_json& json) {
  json["integrator"] = o.integrator;
  json["sampler"] = o.sampler;
  json["samples"] = o.samples_a_pixel();
  json["seed"] = o.seed;
  json["pixel_samples"] = o.position;
  if (o.integrator == "ao") {
    json["radius"] = std::isinf(o.radius) ? nlohmann::ordered_json("inf") : nlohmann::ordered_json(o.radius);
    return;
  }
  json["split"] = o.split.empty() ? fmt::format("1x{}", o.samples) : o.split;
  json["strategy"] = o.strategy;
  json["filter"] = o.filter;
  json["partition"] = !o.no_partition;
}

}  // namespace capcon::cli
