#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "cli/verbs.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace capcon::cli {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Options {
  std::string scene, integrator = "ao", output, position = "centre";
  AmbientOcclusionJob job;
  RendererOptions renderer;
  int width = 0, height = 0;
  bool json = false, quiet = false;
};

/// EXR attributes in pbrt-v4's names, and ours besides.
Attributes attributes_of(const Options& o, const RenderResult& result, const Timings& timings, double seconds) {
  Attributes a;
  a["samplesPerPixel"] = static_cast<int>(o.job.samples);
  a["renderTimeSeconds"] = static_cast<float>(seconds);
  a["integrator"] = o.integrator;
  a["sampler"] = o.job.sampler;
  a["seed"] = static_cast<int>(o.job.seed);
  a["radius"] = static_cast<float>(o.job.radius);
  a["pixelSamples"] = o.position;
  a["device"] = result.device;
  a["timings"] = to_json(timings).dump();
  a["software"] = "capcon " + std::string(version());
  return a;
}

void run(const Options& o) {
  const auto start = Clock::now();
  const bool png = std::filesystem::path(o.output).extension() == ".png";
  if (!png && std::filesystem::path(o.output).extension() != ".exr") {
    throw InputError(fmt::format("-o {}: the image's name must end in .exr or .png", o.output));
  }
  if (o.width < 0 || o.height < 0 || o.width > 16384 || o.height > 16384) {
    throw InputError("--width and --height must be between 1 and 16384");
  }
  if (!(o.job.radius > 0)) throw InputError("--radius must be above 0 (or inf)");
  make_sampler(o.job.sampler, 1, 1);  // an unknown name is said before the work
  check_writable(o.output);
  Scene scene = read_scene(o.scene);
  if (o.width > 0) scene.film.width = o.width;
  if (o.height > 0) scene.film.height = o.height;
  for (const std::string& warning : scene.warnings) {
    if (!o.quiet) fmt::print(stderr, "capcon: warning: {}\n", warning);
  }
  Timings timings;
  timings.wall["read"] = seconds_since(start);
  nlohmann::json device;
  Progress progress("rendering", 1, o.quiet);
  const auto on_progress = [&](double fraction) { progress.update(fraction); };
  const auto finish = [&](const Timings& setup, RenderResult result) {
    timings.wall.insert(setup.wall.begin(), setup.wall.end());
    timings.wall.insert(result.timings.wall.begin(), result.timings.wall.end());
    timings.device = result.timings.device;
    return result;
  };
  RenderResult result;
  if (o.renderer.device == "reference") {
    const Reference reference(scene);
    result = finish(reference.setup(), reference.render(o.job, on_progress));
    device = {{"name", "reference"}};
  } else {
    Renderer renderer(scene, o.renderer);
    result = finish(renderer.setup(), renderer.render(o.job, on_progress));
    device = renderer.device_info();
  }
  const double seconds = seconds_since(start);
  const auto writing = Clock::now();
  if (png) {
    write_png(o.output, result.image);
  } else {
    write_exr(o.output, result.image, attributes_of(o, result, timings, seconds));
  }
  timings.wall["write"] = seconds_since(writing);
  double traced = 0;
  for (const auto& [stage, s] : timings.device) traced += s;
  if (o.json) {
    const nlohmann::json report = {{"output", o.output},
                                   {"scene", scene.name},
                                   {"integrator", o.integrator},
                                   {"width", scene.film.width},
                                   {"height", scene.film.height},
                                   {"sampler", o.job.sampler},
                                   {"samples", o.job.samples},
                                   {"seed", o.job.seed},
                                   {"radius", std::isinf(o.job.radius) ? nlohmann::json("inf") : nlohmann::json(o.job.radius)},
                                   {"pixel_samples", o.position},
                                   {"device", device},
                                   {"rays", result.rays},
                                   {"device_seconds", traced},
                                   {"seconds", seconds_since(start)},
                                   {"timings", to_json(timings)}};
    fmt::print("{}\n", report.dump(2));
  } else if (!o.quiet) {
    fmt::print(stderr, "{}: {}x{}, {} samples of {} on {}, {:.2f} s in all\n", o.output, scene.film.width, scene.film.height,
               o.job.samples, o.job.sampler, result.device, seconds_since(start));
  }
}

}  // namespace

void add_render_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("render", "Render a scene to a float EXR (or a PNG preview)");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Examples:\n"
      "  capcon render scenes/courtyard.pbrt --radius 2 --samples 64 -o courtyard.exr\n"
      "  capcon render scene.pbrt --sampler sobol-owen --device reference -o reference.exr");
  verb->add_option("scene", o->scene, "Scene: .pbrt (v4, v3 or v2 text), .ply or .obj")->required();
  verb->add_option("-o,--output", o->output, "Image to write: .exr (results) or .png (preview)")->required();
  verb->add_option("--sampler", o->job.sampler, "Where sample points come from: random jittered sobol-xor sobol-owen ccvt capcon")
      ->capture_default_str();
  verb->add_option("--samples", o->job.samples, "Occlusion rays a pixel")->capture_default_str()->check(CLI::Range(1u, 1u << 24));
  verb->add_option("--seed", o->job.seed, "Seed of everything random; the same seed gives the same bits")->capture_default_str();
  verb->add_option("--integrator", o->integrator, "ao: ambient occlusion, cosine-weighted")
      ->capture_default_str()
      ->check(CLI::IsMember({"ao"}));
  verb->add_option("--radius", o->job.radius, "Occluders farther away than this do not count (scene units; default inf)")
      ->check(CLI::PositiveNumber);
  verb->add_option("--pixel-samples", o->position, "centre: all samples at the pixel's centre; jittered: each at its own place")
      ->capture_default_str()
      ->check(CLI::IsMember({"centre", "jittered"}));
  verb->add_option("--device", o->renderer.device,
                   "best, lavapipe, a number or name of `capcon info`, or reference (double precision on the CPU)")
      ->capture_default_str();
  verb->add_option("--width", o->width, "Image width, instead of the scene's");
  verb->add_option("--height", o->height, "Image height, instead of the scene's");
  verb->add_option("--fetch", o->renderer.fetch, "How kernels read data: auto, texel or storage")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "texel", "storage"}));
  verb->add_flag("--validate", o->renderer.validate, "Load the Vulkan validation layer; any message is a failure");
  verb->add_flag("--json", o->json, "Print what was done and how long each stage took as JSON on stdout");
  verb->add_flag("--quiet", o->quiet, "No progress bar, no messages");
  verb->callback([o] {
    o->job.position = o->position == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
    run(*o);
  });
}

}  // namespace capcon::cli
