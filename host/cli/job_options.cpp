#include "cli/job_options.h"
#include "cli/positive.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "sampling/point_file.h"

namespace capcon::cli {
namespace {

constexpr std::uint32_t kMostSamples = 1u << 24;

Strategy strategy_of(const std::string& name) {
  if (name == "balance") return Strategy::balance;
  if (name == "lights") return Strategy::lights;
  return name == "bsdf" ? Strategy::bsdf : Strategy::power;
}

/// A label that is safe in tables, and where points came from if that is a file.
void describe_sampler(const std::string& name, const std::string& sampler, Attributes& a) {
  a[name] = sampler_label(sampler);
  if (is_point_file(sampler)) a[name + "File"] = parse_point_file(sampler).path;
}

void describe_sampler(const std::string& name, const std::string& sampler, nlohmann::ordered_json& json) {
  json[name] = sampler_label(sampler);
  if (is_point_file(sampler)) json[name + "_file"] = parse_point_file(sampler).path;
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
  verb.add_option(
          "--integrator", integrator,
          "ao: ambient occlusion, cosine-weighted; direct: light straight from the lights; igi: instant "
          "global illumination; path: path tracing, on the reference alone")
      ->capture_default_str()
      ->check(CLI::IsMember({"ao", "direct", "igi", "path"}));
  auto* name =
      verb.add_option(
              "--sampler", sampler,
              "Where sample points come from: random jittered sobol-xor sobol-owen ccvt capcon "
              "capcon-domain capcon-ranked fpo halton lattice pmj02 sobol-z capcon-screen capcon-bounded, or "
              "file:PATH[:shift|xor|none][:sequence] for your own")
          ->capture_default_str();
  auto* on_screen =
      verb.add_option("--screen", screen,
                      "blue: sets are given to pixels so that the image's error is blue noise, which eye and "
                      "denoiser smooth away: capcon-domain becomes capcon-screen (at most 256 samples)")
          ->capture_default_str()
          ->check(CLI::IsMember({"none", "blue"}));
  verb.parse_complete_callback([this, name, on_screen] {
    if (on_screen->count() == 0 || screen != "blue") return;
    if (name->count() > 0 && sampler != "capcon-domain" && sampler != "capcon-screen") {
      throw InputError(
          "--screen blue is for --sampler capcon-domain; sobol-z has an order of its own on the "
          "screen, other samplers none");
    }
    sampler = "capcon-screen";
  });
  auto* count = verb.add_option("--samples", samples,
                                "ao: occlusion rays a pixel; direct, igi: as --split 1xN; path: paths")
                    ->capture_default_str()
                    ->check(CLI::Range(1u, kMostSamples));
  verb.add_option(
          "--split", split,
          "PxI, direct, igi: P image samples a pixel, each with I points on every light and I for the BSDF")
      ->excludes(count);
  verb.add_flag(
      "--no-partition", no_partition,
      "Direct, igi: the P sets of a pixel, and the sets of light paths, are sets of their own, not the "
      "parts of one");
  verb.add_option("--seed", seed, "Seed of everything random; the same seed gives the same bits")
      ->capture_default_str();
  verb.add_option("--radius", radius,
                  "ao: occluders farther away than this do not count (scene units; default inf)")
      ->check(positive_number());
  verb.add_option(
          "--strategy", strategy,
          "Direct, igi: how light and BSDF samples are combined: power, balance (heuristics); lights, "
          "bsdf (alone)")
      ->capture_default_str()
      ->check(CLI::IsMember({"power", "balance", "lights", "bsdf"}));
  verb.add_option("--pixel-samples", position,
                  "centre: all image samples at the pixel's centre; jittered: each at its own place")
      ->capture_default_str()
      ->check(CLI::IsMember({"centre", "jittered"}));
  verb.add_option("--filter", filter,
                  "Direct, igi, jittered: how places in a pixel weigh: box, gaussian (radius 1.5)")
      ->capture_default_str()
      ->check(CLI::IsMember({"box", "gaussian"}));
  add_global_illumination(verb);
}

void JobOptions::add_global_illumination(CLI::App& verb) {
  verb.add_option("--paths", paths, "igi: light paths of a set")
      ->capture_default_str()
      ->check(CLI::Range(1u, 1u << 20));
  verb.add_option("--sets", sets, "igi: sets of virtual point lights; every image sample uses one")
      ->capture_default_str()
      ->check(CLI::Range(1u, 1u << 16));
  verb.add_option("--path-sampler", path_sampler, "igi: where light paths start (default: as --sampler)");
  verb.add_option(
          "--clamping", clamping,
          "igi: what becomes of the geometry term in corners: compensate (unbiased), clamp (dark corners), "
          "none (bright spots)")
      ->capture_default_str()
      ->check(CLI::IsMember({"compensate", "clamp", "none"}));
  verb.add_option(
          "--limit", limit,
          "igi: the most that the geometry term may be, 1 / square scene unit (default: by the scene's size)")
      ->check(positive_number());
  verb.add_option("--gather", gather,
                  "igi: rays for what clamping leaves out, for each set of an image sample")
      ->capture_default_str()
      ->check(CLI::Range(1u, 1024u));
  verb.add_option("--block", block,
                  "igi: interleaved sampling: pixels of KxK have sets of their own (K^2 divides --sets)")
      ->capture_default_str()
      ->check(CLI::Range(1u, 64u));
  verb.add_flag("--two-sided", two_sided,
                "igi: virtual lights shine to both sides, as pbrt-v2's: light leaks through thin walls");
  verb.add_flag("--indirect", indirect, "igi, path: leave out what comes straight from lights");
}

/// What does not go together.
void JobOptions::check() const {
  const bool shaded = integrator == "direct" || integrator == "igi";
  if (integrator == "ao" && !(radius > 0)) throw InputError("--radius must be above 0 (or inf)");
  if (integrator != "ao" && std::isfinite(radius)) throw InputError("--radius is for --integrator ao");
  if (!shaded && (!split.empty() || no_partition || filter != "box" || strategy != "power")) {
    throw InputError("--split, --no-partition, --filter and --strategy are for --integrator direct and igi");
  }
  if (filter != "box" && position != "jittered")
    throw InputError("--filter gaussian places image samples: it goes with --pixel-samples jittered");
  const JobOptions usual;
  const bool global = !path_sampler.empty() || clamping != usual.clamping || paths != usual.paths ||
                      sets != usual.sets || gather != usual.gather || block != usual.block || limit != 0 ||
                      two_sided;
  if (integrator != "igi" && global) {
    throw InputError(
        "--paths, --sets, --path-sampler, --clamping, --limit, --gather, --block and --two-sided are for "
        "--integrator "
        "igi");
  }
  if (indirect && integrator != "igi" && integrator != "path")
    throw InputError("--indirect is for --integrator igi and path");
}

DirectLightingJob JobOptions::direct_job() const {
  DirectLightingJob job;
  job.sampler = sampler;
  std::tie(job.image_samples, job.integrator_samples) =
      split.empty() ? std::pair(1u, samples) : parse_split(split);
  job.seed = seed;
  job.position = position == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
  job.filter = filter == "box" ? PixelFilter::box : PixelFilter::gaussian;
  job.strategy = strategy_of(strategy);
  job.partition = !no_partition;
  return job;
}

GlobalIlluminationJob JobOptions::global_illumination_job() const {
  GlobalIlluminationJob job;
  job.direct = direct_job();
  job.sampler = path_sampler.empty() ? sampler : path_sampler;
  job.paths = paths;
  job.sets = sets;
  job.partition = !no_partition;
  job.clamping = clamping == "none"    ? Clamping::none
                 : clamping == "clamp" ? Clamping::clamp
                                       : Clamping::compensate;
  job.limit = limit;
  job.gather = gather;
  job.block = block;
  job.only_indirect = indirect;
  job.two_sided = two_sided;
  check_job(job);
  return job;
}

Job JobOptions::job() const {
  check_sampler(sampler);  // told before the work
  check();
  const PixelPosition place = position == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
  if (integrator == "ao") return AmbientOcclusionJob{radius, sampler, samples, seed, place};
  if (integrator == "path") return PathTracingJob{samples, seed, place, indirect};
  if (integrator == "direct") return direct_job();
  if (!path_sampler.empty()) check_sampler(path_sampler);
  return global_illumination_job();
}

std::uint32_t JobOptions::samples_a_pixel() const {
  if (split.empty()) return samples;
  const auto [image, points] = parse_split(split);
  return image * points;
}

std::string JobOptions::key() const {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {:016x} {:016x}", integrator,
                     sampler, samples, split, seed, radius, position, filter, strategy, no_partition,
                     path_sampler, clamping, paths, sets, limit, gather, block, indirect, two_sided,
                     point_file_fingerprint(sampler), point_file_fingerprint(path_sampler));
}

void describe(const JobOptions& o, Attributes& a) {
  a["samplesPerPixel"] = static_cast<int>(o.samples_a_pixel());
  a["integrator"] = o.integrator;
  describe_sampler("sampler", o.sampler, a);
  a["seed"] = static_cast<int>(o.seed);
  a["pixelSamples"] = o.position;
  if (o.integrator == "ao") {
    a["radius"] = static_cast<float>(o.radius);
    return;
  }
  if (o.indirect) a["light"] = "indirect";
  if (o.integrator == "path") return;
  if (o.integrator == "igi") {
    describe_sampler("pathSampler", o.path_sampler.empty() ? o.sampler : o.path_sampler, a);
    a["lightPaths"] = static_cast<int>(o.paths);
    a["lightSets"] = static_cast<int>(o.sets);
    a["clamping"] = o.clamping;
    a["geometryLimit"] = static_cast<float>(o.limit);
    a["gatherRays"] = static_cast<int>(o.gather);
    a["block"] = static_cast<int>(o.block);
    if (o.two_sided) a["virtualLights"] = "two-sided";
  }
  a["split"] = o.split.empty() ? fmt::format("1x{}", o.samples) : o.split;
  a["strategy"] = o.strategy;
  a["filter"] = o.filter;
  a["partition"] = o.no_partition ? "none" : "parts of one set";
}

void describe(const JobOptions& o, nlohmann::ordered_json& json) {
  json["integrator"] = o.integrator;
  describe_sampler("sampler", o.sampler, json);
  json["samples"] = o.samples_a_pixel();
  json["seed"] = o.seed;
  json["pixel_samples"] = o.position;
  if (o.integrator == "ao") {
    json["radius"] = std::isinf(o.radius) ? nlohmann::ordered_json("inf") : nlohmann::ordered_json(o.radius);
    return;
  }
  if (o.indirect) json["light"] = "indirect";
  if (o.integrator == "path") return;
  if (o.integrator == "igi") {
    describe_sampler("path_sampler", o.path_sampler.empty() ? o.sampler : o.path_sampler, json);
    json["paths"] = o.paths;
    json["sets"] = o.sets;
    json["clamping"] = o.clamping;
    json["limit"] =
        o.limit > 0 ? nlohmann::ordered_json(o.limit) : nlohmann::ordered_json("by the scene's size");
    json["gather"] = o.gather;
    json["block"] = o.block;
    if (o.two_sided) json["virtual_lights"] = "two-sided";
  }
  json["split"] = o.split.empty() ? fmt::format("1x{}", o.samples) : o.split;
  json["strategy"] = o.strategy;
  json["filter"] = o.filter;
  json["partition"] = !o.no_partition;
}

}  // namespace capcon::cli
