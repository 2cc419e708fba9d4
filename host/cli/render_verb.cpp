#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/progress.h"
#include "base/stop.h"
#include "cli/cold_explain.h"
#include "cli/job_options.h"
#include "cli/profile_table.h"
#include "cli/verbs.h"
#include "cli/virtual_lights_option.h"
#include "distributed/share_renderer.h"
#include "image/exr_rows.h"
#include "image/partial_image.h"
#include "reference/reference.h"
#include "render/explain.h"
#include "render/features.h"
#include "render/renderer.h"
#include "render/renderer_state.h"
#include "scene/scene.h"
#include "study/scene_facts.h"

namespace capcon::cli {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Options {
  std::string scene, output, lights;  // lights: where virtual point lights are shown
  JobOptions job;
  RendererOptions renderer;
  int width = 0, height = 0;
  bool json = false, quiet = false, profile = false, explain = false;
  int processes = 1;  ///< that make the image together
};

/// EXR attributes in pbrt-v4's names, and ours besides.
Attributes attributes_of(const Options& o, const RenderResult& result, const Timings& timings,
                         double seconds) {
  Attributes a;
  describe(o.job, a);
  a["renderTimeSeconds"] = static_cast<float>(seconds);
  a["device"] = result.device;
  a["timings"] = to_json(timings).dump();
  a["software"] = "capcon " + std::string(version());
  if (o.processes > 1) a["processes"] = o.processes;
  return a;
}

void check(const Options& o, const Job& job) {
  const auto extension = std::filesystem::path(o.output).extension();
  if (!o.lights.empty()) check_light_file(o.lights, job);
  if ((o.explain || !o.lights.empty()) && o.output.empty()) return;
  if (o.output.empty()) throw InputError("name the image to write with -o");
  if (extension != ".png" && extension != ".exr") {
    throw InputError(fmt::format("-o {}: the image's name must end in .exr or .png", o.output));
  }
  check_writable(o.output);
}

/// What a render leaves behind: the image is written, unless that is done later.
struct Outcome {
  RenderResult result;  ///< without the image where it was written row by row
  Timings timings;
  nlohmann::json device;
};

/// Everything that makes the image what it is.
std::uint64_t job_key(const Options& o, const Scene& scene, const std::string& device) {
  const std::string together = o.processes > 1 ? fmt::format(" by {} processes", o.processes) : "";
  return fnv1a64(fmt::format("{} {:016x} {} {} {} {} {}{}", version(), fingerprint(scene),
                             points_fingerprint(), scene.film.width, scene.film.height, o.job.key(), device,
                             together));
}

void merge(const Timings& from, Timings& into) {
  for (const auto& [stage, s] : from.wall) into.wall[stage] += s;
  for (const auto& [stage, s] : from.device) into.device[stage] += s;
}

/// An image too large to be held: rows go to a file beside the output as they come, and from there into the
/// image. A run that was stopped goes on where it was.
Outcome render_large(const Options& o, const Scene& scene, ShareRenderer& renderer, nlohmann::json device,
                     Timings timings, Clock::time_point start) {
  const int width = scene.film.width, height = scene.film.height;
  const int rows = std::max(1, static_cast<int>(kBandPixels) / width);
  Outcome outcome{{}, std::move(timings), std::move(device)};
  PartialImage partial(o.output + ".partial", job_key(o, scene, outcome.device.at("name")), width, height,
                       o.job.channels());
  if (partial.row_count() > 0 && !o.quiet) {
    fmt::print(stderr, "capcon: going on from {} of {} rows in {}.partial\n", partial.row_count(), height,
               o.output);
  }
  const auto kept = [&] {
    return fmt::format("{} of {} rows are kept in {}.partial, and the same command goes on from there",
                       partial.row_count(), height, o.output);
  };
  StopMessage stop(kept());
  Progress progress("rendering", height, o.quiet);
  for (int first = 0; first < height; first += rows) {
    const int count = std::min(rows, height - first);
    progress.update(first);
    if (partial.has(first, count)) continue;
    RenderResult band;
    try {
      band = renderer.render_rows(first, count,
                                  [&](double fraction) { progress.update(first + fraction * count); });
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{}; {}", failure.what(), kept()));
    }
    const auto writing = Clock::now();
    partial.add(first, band.image.pixels);
    stop.say(kept());
    merge(band.timings, outcome.timings);
    outcome.timings.wall["write"] += seconds_since(writing);
    if (outcome.result.rays == 0) outcome.result.first_dispatch = band.first_dispatch;
    outcome.result.rays += band.rays;
    outcome.result.device = band.device;
  }
  const auto writing = Clock::now();
  outcome.result.device = outcome.device.at("name");
  ExrRows file(o.output, width, height, o.job.channels(),
               attributes_of(o, outcome.result, outcome.timings, seconds_since(start)));
  partial.read([&](std::span<const float> pixels) { file.write(pixels); });
  file.finish();
  partial.remove();
  outcome.timings.wall["write"] += seconds_since(writing);
  return outcome;
}

void write(const Options& o, Outcome& outcome, Clock::time_point start) {
  if (o.output.empty()) return;  // the job's virtual lights alone are wanted
  const double seconds = seconds_since(start);
  const auto writing = Clock::now();
  if (std::filesystem::path(o.output).extension() == ".png") {
    write_png(o.output, outcome.result.image);
  } else {
    write_exr(o.output, outcome.result.image, attributes_of(o, outcome.result, outcome.timings, seconds));
  }
  outcome.timings.wall["write"] = seconds_since(writing);
}

void say(const Options& o, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (!o.quiet) fmt::print(stderr, "capcon: warning: {}\n", warning);
  }
}

/// A list of virtual lights needs no image.
bool needs_image(const Options& o) {
  return !o.output.empty() || is_light_picture(o.lights);
}

template <typename Tracer>  // Renderer or Reference
void show_lights(const Options& o, const Job& job, const Scene& scene, const Image& image, Tracer& tracer) {
  if (o.lights.empty()) return;
  write_lights(o.lights, scene, std::get<GlobalIlluminationJob>(job), image, tracer);
}

Outcome render_on_device(const Options& o, const Job& job, Scene& scene, PendingDevice device,
                         Timings timings, Clock::time_point start, const Ranks& ranks) {
  Renderer renderer(scene, o.renderer, std::move(device), &job);
  say(o, renderer.warnings());
  merge(renderer.setup(), timings);
  ShareRenderer together(ranks, job, [&](const Job& share, int first, int rows, const auto& on_progress) {
    return renderer.render_rows(share, first, rows, on_progress);
  });
  Outcome outcome{{}, std::move(timings), renderer.device_info()};
  if (!ranks.first()) {
    together.help();
    return outcome;
  }
  const bool exr = std::filesystem::path(o.output).extension() == ".exr";
  if (exr && std::size_t(scene.film.width) * scene.film.height > kBandPixels && o.lights.empty())
    return render_large(o, scene, together, outcome.device, std::move(outcome.timings), start);
  Progress progress("rendering", 1, o.quiet);
  if (needs_image(o)) {
    outcome.result =
        together.render_rows(0, scene.film.height, [&](double fraction) { progress.update(fraction); });
  }
  merge(outcome.result.timings, outcome.timings);
  show_lights(o, job, scene, outcome.result.image, renderer);
  write(o, outcome, start);
  return outcome;
}

Outcome render(const Options& o, const Job& job, Scene& scene, PendingDevice device, Timings timings,
               Clock::time_point start, const Ranks& ranks) {
  if (o.renderer.device != "reference")
    return render_on_device(o, job, scene, std::move(device), std::move(timings), start, ranks);
  const Reference reference(scene);
  Progress progress("rendering", 1, o.quiet);
  Outcome outcome{{}, std::move(timings), {{"name", "reference"}}};
  if (needs_image(o))
    outcome.result = reference.render(job, [&](double fraction) { progress.update(fraction); });
  say(o, reference.warnings());
  merge(reference.setup(), outcome.timings);
  merge(outcome.result.timings, outcome.timings);
  show_lights(o, job, scene, outcome.result.image, reference);
  write(o, outcome, start);
  return outcome;
}

nlohmann::ordered_json report(const Options& o, const Scene& scene, const Outcome& outcome, double seconds,
                              double first_dispatch) {
  double traced = 0;
  for (const auto& [stage, s] : outcome.timings.device) traced += s;
  nlohmann::ordered_json json = {{"output", o.output},
                                 {"scene", scene.name},
                                 {"width", scene.film.width},
                                 {"height", scene.film.height}};
  describe(o.job, json);
  json["device"] = outcome.device;
  if (o.processes > 1) json["processes"] = o.processes;
  json["rays"] = outcome.result.rays;
  if (outcome.result.virtual_lights > 0) json["virtual_lights"] = outcome.result.virtual_lights;
  json["device_seconds"] = traced;
  json["seconds"] = seconds;
  json["timings"] = to_json(outcome.timings);
  if (first_dispatch > 0) json["first_dispatch_seconds"] = first_dispatch;
  return json;
}

void run_explain(const Options& o) {
  const Explanation e = cold_explain(o.scene, o.width, o.height, o.job.job(), o.renderer, 5);
  fmt::print("{}", o.json ? to_json(e).dump(2) + "\n" : to_text(e));
  if (!e.identical)
    throw Failure("the image differs when everything is kept: this is a defect, please report it");
}

/// What several processes together cannot do; all but the first keep silent.
void join(Options& o, const Ranks& ranks) {
  if (ranks.alone()) return;
  o.processes = ranks.size();
  if (o.explain) throw InputError("--explain is about one process: leave out mpirun");
  if (o.renderer.device == "reference")
    throw InputError("the reference renders in one process: leave out mpirun, or --device reference");
  o.renderer.device = device_of_rank(o.renderer.device, ranks.on_this_machine());
  if (!ranks.first()) o.quiet = true;
}

void run(Options& o) {
  const auto start = Clock::now();
  const Ranks ranks;
  join(o, ranks);
  if (o.width < 0 || o.height < 0 || o.width > 16384 || o.height > 16384) {
    throw InputError("--width and --height must be between 1 and 16384");
  }
  const Job job = o.job.job();
  if (ranks.first()) check(o, job);
  const bool on_reference = o.renderer.device == "reference";
  if (o.explain) {
    if (on_reference) throw InputError("--explain is about a Vulkan device; leave out --device reference");
    run_explain(o);
    if (!needs_image(o) && o.lights.empty()) return;
  }
  PendingDevice device;
  if (!on_reference) device = open_device(o.renderer);
  Scene scene = read_scene(o.scene, needed_reading(job, o.renderer.keep_everything));
  if (o.width > 0) scene.film.width = o.width;
  if (o.height > 0) scene.film.height = o.height;
  say(o, scene.warnings);
  Timings timings;
  timings.wall["read"] = seconds_since(start);
  const Outcome outcome = render(o, job, scene, std::move(device), std::move(timings), start, ranks);
  if (!ranks.first()) return;
  const double seconds = seconds_since(start);
  const double first_dispatch = std::chrono::duration<double>(outcome.result.first_dispatch - start).count();
  if (o.profile && !o.quiet)
    fmt::print(stderr, "{}", profile_table(outcome.timings, seconds, first_dispatch));
  if (o.json) {
    fmt::print("{}\n", report(o, scene, outcome, seconds, first_dispatch).dump(2));
  } else if (!o.quiet) {
    fmt::print(stderr, "{}: {}x{}, {} samples of {} on {}, {:.2f} s in all\n",
               o.output.empty() ? o.lights : o.output, scene.film.width, scene.film.height,
               o.job.samples_a_pixel(), o.job.sampler, outcome.device.value("name", ""), seconds);
  }
}

}  // namespace

void add_render_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("render", "Render a scene to a float EXR (or a PNG preview)");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Examples:\n"
      "  capcon render scenes/courtyard.pbrt --radius 2 --samples 64 -o courtyard.exr\n"
      "  capcon render scenes/direct.pbrt --integrator direct --split 4x16 --pixel-samples jittered -o "
      "direct.exr\n"
      "  capcon render scene.pbrt --sampler sobol-owen --device reference -o reference.exr\n"
      "  capcon render scene.pbrt --explain");
  verb->add_option("scene", o->scene, "Scene: .pbrt (v4, v3 or v2 text), .ply or .obj")->required();
  verb->add_option("-o,--output", o->output, "Image to write: .exr (results) or .png (preview)");
  o->job.add_to(*verb);
  verb->add_option(
      "--show-virtual-lights", o->lights,
      "igi: where the virtual point lights lie: a picture (.png) over the dimmed image, or a list "
      "(.csv, .json); -o may be left out");
  verb->add_option(
          "--device", o->renderer.device,
          "best, lavapipe, a number or name of `capcon info`, or reference (double precision on the CPU)")
      ->capture_default_str();
  verb->add_option("--width", o->width, "Image width, instead of the scene's");
  verb->add_option("--height", o->height, "Image height, instead of the scene's");
  verb->add_option("--fetch", o->renderer.fetch, "How kernels read data: auto, texel or storage")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "texel", "storage"}));
  verb->add_option("--instancing", o->renderer.instancing,
                   "auto; flat: one tree over all instances; two-level: a tree of instances (less memory, "
                   "slower rays)")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "flat", "two-level"}));
  verb->add_option("--tree", o->renderer.tree,
                   "auto; fast: sooner there; best: primitives cut for fewer visits, for many rays")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "fast", "best"}));
  verb->add_flag("--profile", o->profile, "Print where the time went, a row a stage");
  verb->add_flag(
      "--explain", o->explain,
      "Print what was left out because the job does not need it, and what that saved (-o may be left out)");
  verb->add_flag("--keep-everything", o->renderer.keep_everything,
                 "Leave nothing out: the same image, slower");
  verb->add_flag("--validate", o->renderer.validate,
                 "Load the Vulkan validation layer; any message is a failure");
  verb->add_flag("--json", o->json, "Print what was done and how long each stage took as JSON on stdout");
  verb->add_flag("--quiet", o->quiet, "No progress bar, no messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
