#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/cold_explain.h"
#include "cli/positive.h"
#include "cli/study_parts.h"
#include "cli/study_samplers.h"
#include "cli/verbs.h"
#include "distributed/share_renderer.h"
#include "reference/reference.h"
#include "render/features.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "study/format.h"
#include "study/ranks_study.h"
#include "study/scene_facts.h"
#include "study/study.h"
#include "study/study_lock.h"
#include "study/table.h"

namespace capcon::cli {
namespace {

constexpr double kCourtyardRadius = 2;         // metres
constexpr double kDefaultPixels = 6000;        // a study of all samplers in two to four minutes on two cores
constexpr double kDefaultGlobalPixels = 2028;  // the same, with some 200 virtual lights a set for each
constexpr std::uint32_t kReferenceSets = 64;

struct Options {
  StudySettings settings;
  RunnerOptions runner;
  std::string scene;
  std::string directory;
  std::string samples = "1,2,4..256";
  std::string position = "centre", clamping = "compensate";
  std::string device = "best";
  StudyParts parts;
  bool no_close_ups = false;
  bool json = false;
};

/// The words after the program's name, those with blanks quoted.
std::string command_line() {
  std::string line = "capcon";
  std::string bytes;
  try {
    bytes = read_file("/proc/self/cmdline");
  } catch (const InputError&) {
    return line + " study";
  }
  std::size_t begin = bytes.find('\0') + 1;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find('\0', begin), bytes.size());
    const std::string word = bytes.substr(begin, end - begin);
    line += word.find_first_of(" \t\"'\\$*") == std::string::npos && !word.empty() ? " " + word
                                                                                   : " '" + word + "'";
    begin = end + 1;
  }
  return line;
}

StudyDevice make_device(Scene scene, const std::string& device, bool shading, int width, int height) {
  scene.film.width = width;
  scene.film.height = height;
  if (device == "reference") {
    const auto kept = std::make_shared<const Scene>(std::move(scene));  // a Reference keeps a reference to it
    auto reference = std::make_shared<Reference>(*kept);
    return {[kept, reference](const Job& job) { return reference->render(job); },
            {{"name", "reference (double precision on the CPU)"}}};
  }
  RendererOptions options;
  options.device = device;
  options.shading = shading;
  auto renderer = std::make_shared<Renderer>(scene, options);
  return {[renderer](const Job& job) { return renderer->render(job); }, renderer->device_info()};
}

/// The shipped scene of each study.
std::string shipped_scene(Integral integral) {
  if (integral == Integral::ambient_occlusion) return "scenes/courtyard.pbrt";
  if (integral == Integral::global_illumination) return "scenes/nave.pbrt";
  return integral == Integral::direct ? "scenes/direct.pbrt" : "scenes/splitting.pbrt";
}

/// The numbers of image samples that N points can be split into.
std::vector<std::uint32_t> splits_of(std::uint32_t combined) {
  std::vector<std::uint32_t> counts;
  for (std::uint32_t p = 1; p <= combined; ++p) {
    if (combined % p == 0) counts.push_back(p);
  }
  return counts;
}

/// The study.json; empty where others make it.
nlohmann::json work(Options& o, const Ranks& ranks, const std::optional<Baseline>& baseline) {
  o.parts.check(ranks);
  if (!ranks.first()) o.runner.quiet = true;
  o.runner.shares_device = share_a_device(o.device, ranks.size_of_machine());
  o.device = device_of_rank(o.device, ranks.on_this_machine());
  StudySettings& s = o.settings;
  settle_samplers(s);
  s.position = o.position == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
  s.samples = s.integral == Integral::splitting ? splits_of(s.combined) : parse_samples(o.samples);
  s.clamping = o.clamping == "none"    ? Clamping::none
               : o.clamping == "clamp" ? Clamping::clamp
                                       : Clamping::compensate;
  s.close_ups = !o.no_close_ups;
  s.command = command_line();
  const std::string shipped = shipped_scene(s.integral);
  s.scene = o.scene.empty() ? shipped + " (shipped)" : o.scene;
  const std::string scene_path = o.scene.empty() ? shipped_file(shipped).string() : o.scene;
  const Job example = make_job(s, {s.samplers.front(), s.samples.front(), 1});
  make_job(s, {s.samplers.front(), s.samples.back(), 1});  // what cannot be is told before the work
  make_reference_job(s, 0);
  check_point_files(s);
  Scene scene = read_scene(scene_path, needed_reading(example, false));
  if (!o.runner.quiet) {
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "capcon: warning: {}\n", warning);
  }
  s.scene_fingerprint = fingerprint(scene);
  s.points_fingerprint = points_fingerprint();
  s.unique_triangles = scene.unique_triangles();
  s.instanced_triangles = scene.instanced_triangles();
  if (s.radius == 0) s.radius = o.scene.empty() ? kCourtyardRadius : default_radius(scene);
  const bool global = s.integral == Integral::global_illumination;
  set_film(scene, s.width, s.height, global ? kDefaultGlobalPixels : kDefaultPixels);
  s.width = scene.film.width;
  s.height = scene.film.height;

  if (baseline) check_comparable(*baseline, to_json(s));
  o.runner.directory = o.directory;
  const bool shading = s.integral != Integral::ambient_occlusion;
  const MakeStudyDevice make = [&](int width, int height) {
    return make_device(scene, o.device, shading, width, height);
  };
  if (o.parts.is_part()) {
    run_part(o.parts, s, make, o.runner, ranks);
    return {};
  }
  std::optional<StudyLock> alone;
  if (ranks.first()) alone.emplace(o.directory);
  std::optional<StudyResult> merged;
  if (!ranks.alone()) {
    merged = run_by_ranks(s, make(s.width, s.height), o.runner, ranks);
    if (!merged) return {};  // not the first rank
  }
  std::optional<Explanation> explanation;
  if (o.device != "reference") {
    RendererOptions options;
    options.device = o.device;
    const Job job = make_job(s, {s.samplers.front(), s.samples[s.samples.size() / 2], 1});
    explanation = cold_explain(scene_path, s.width, s.height, job, options, 3);
  }
  StudyReport report = merged ? make_report(std::move(*merged), make, o.runner, explanation)
                              : study_report(s, make, o.runner, explanation);
  let_go(ranks);
  const std::string lines = hold_against(baseline, report.json);
  if (o.json) {
    fmt::print("{}\n", report.json.dump(2));
  } else {
    fmt::print("{}{}", text_tables(report.result, report.figures), lines);
  }
  if (!o.runner.quiet) {
    if (!report.result.moved.empty()) {
      fmt::print(stderr, "capcon: older runs with other settings are kept in {}\n",
                 report.result.moved.string());
    }
    if (report.result.resumed > 0) {
      fmt::print(stderr, "capcon: {} of {} runs were there before; --fresh measures them again\n",
                 report.result.resumed, report.result.records.size());
    }
    fmt::print(stderr, "The report is {}\n",
               std::filesystem::absolute(report.page).lexically_normal().string());
  }
  return report.json;
}

void run(Options& o) {
  std::optional<Baseline> baseline;
  if (!o.parts.baseline.empty()) baseline = read_baseline(o.parts.baseline);
  nlohmann::json study;
  {
    const Ranks ranks;  // left before anything is judged
    study = work(o, ranks, baseline);
  }
  judge(baseline, study);
}

/// What all studies take.
void add_options(CLI::App* study, const std::shared_ptr<Options>& o) {
  StudySettings& s = o->settings;
  o->directory = "report/" + std::string(words_of(s.integral).slug);
  study->add_option("scene", o->scene,
                    fmt::format(".pbrt, .ply or .obj (default: the shipped {})", shipped_scene(s.integral)));
  study
      ->add_option("-o,--output", o->directory,
                   "folder for report.html, runs.jsonl, study.json, reference.exr")
      ->capture_default_str();
  study->add_option("--seeds", s.seeds, "seeds 1 ... N; intervals need two at least")
      ->check(CLI::Range(1u, 4096u))
      ->capture_default_str();
  const bool global = s.integral == Integral::global_illumination;
  study
      ->add_option(
          "--width", s.width,
          fmt::format("pixels (default: about {} in all, in the film's shape)",
                      grouped(static_cast<std::uint64_t>(global ? kDefaultGlobalPixels : kDefaultPixels))))
      ->check(CLI::Range(1, 16384));
  study->add_option("--height", s.height, "pixels")->check(CLI::Range(1, 16384));
  study
      ->add_option("--device", o->device,
                   "best, lavapipe, a number of `capcon info`, part of a name, or reference")
      ->capture_default_str();
  const std::string many(words_of(s.integral).many);
  study
      ->add_option("--reference-" + many, s.reference_samples,
                   fmt::format("{} of each of the reference's 4 groups", words_of(s.integral).counts))
      ->check(CLI::Range(1u, 1u << 20))
      ->capture_default_str();
  o->parts.add_to(*study);
  study->add_flag("--no-close-ups", o->no_close_ups, "leave the larger pictures out of the report");
  study->add_flag("--fresh", o->runner.fresh, "measure again what is already there");
  study->add_flag("--json", o->json, "print study.json instead of tables");
  study->add_flag("--quiet", o->runner.quiet, "no progress and no messages");
  study->callback([o] { run(*o); });
}

void add_samples(CLI::App* study, const std::shared_ptr<Options>& o) {
  study
      ->add_option("--samplers", o->settings.samplers,
                   "any of: random jittered sobol-xor sobol-owen ccvt capcon capcon-domain fpo halton "
                   "lattice pmj02 capcon-ranked (default: all but the last five), and "
                   "file:PATH[:shift|xor|none][:sequence] "
                   "for your own points")
      ->delimiter(',')
      ->allow_extra_args(false);
  study->add_option("--samples", o->samples, "samples a pixel: counts and doubling ranges")
      ->capture_default_str();
}

/// Samplers of studies that know variants.
void add_variants(CLI::App* study, const std::shared_ptr<Options>& o, const std::string& standard) {
  study
      ->add_option(
          "--samplers", o->settings.samplers,
          fmt::format(
              "samplers, or file:PATH; X-naive: X without partition, X-naive2: the same with twice the "
              "points "
              "(default: {})",
              standard))
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_light_paths(CLI::App* study, const std::shared_ptr<Options>& o) {
  StudySettings& s = o->settings;
  o->samples = "1,2,4..16";
  s.reference_samples = kReferenceSets;
  study->add_option("--sets", o->samples, "sets of light paths: counts and doubling ranges")
      ->capture_default_str();
  study->add_option("--paths", s.paths, "N: light paths a set")
      ->check(CLI::Range(1u, 1u << 16))
      ->capture_default_str();
  study
      ->add_option(
          "--clamping", o->clamping,
          "what becomes of the geometry term above its limit, in the reference too: compensate, clamp, none")
      ->check(CLI::IsMember({"compensate", "clamp", "none"}))
      ->capture_default_str();
  study
      ->add_option(
          "--limit", s.limit,
          "the most that the geometry term may be, 1 / square scene unit (default: by the scene's size)")
      ->check(positive_number());
}

std::shared_ptr<Options> options_for(Integral integral) {
  auto o = std::make_shared<Options>();
  o->settings.integral = integral;
  return o;
}

}  // namespace

void add_study_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("study", "error against run time: samplers x samples x seeds, and a report");
  verb->require_subcommand(1);
  {
    CLI::App* study = verb->add_subcommand("ambient-occlusion", "ambient occlusion of one scene");
    auto o = options_for(Integral::ambient_occlusion);
    add_options(study, o);
    add_samples(study, o);
    study
        ->add_option("--radius", o->settings.radius,
                     "occluders farther away do not count (default: 2 in the courtyard, else 1/20 of the "
                     "scene's diagonal)")
        ->check([](const std::string& text) {
          char* end = nullptr;
          return std::strtod(text.c_str(), &end) > 0 && *end == '\0'
                     ? std::string()
                     : text + " is no positive number, nor inf";
        });
  }
  {
    CLI::App* study = verb->add_subcommand("direct", "direct lighting with multiple importance sampling");
    auto o = options_for(Integral::direct);
    add_options(study, o);
    add_samples(study, o);
  }
  {
    CLI::App* study = verb->add_subcommand(
        "splitting", "trajectory splitting: image samples x integrator samples, N in all");
    auto o = options_for(Integral::splitting);
    add_options(study, o);
    study->add_option("--combined", o->settings.combined, "N: points a pixel on each light and for the BSDF")
        ->check(CLI::Range(1u, 1024u))
        ->capture_default_str();
    add_variants(study, o, "capcon, its naive variants, capcon-domain, sobol-xor, sobol-owen");
    study->add_option("--pixel-samples", o->position, "centre: shows the integral's error alone; jittered")
        ->check(CLI::IsMember({"centre", "jittered"}))
        ->capture_default_str();
  }
  {
    CLI::App* study = verb->add_subcommand(
        "igi", "instant global illumination: sets of light paths, indirect light, noise against structure");
    auto o = options_for(Integral::global_illumination);
    add_light_paths(study, o);
    add_options(study, o);
    add_variants(study, o, "random, sobol-xor, sobol-owen, halton, capcon, capcon-naive, fpo, capcon-domain");
  }
}

}  // namespace capcon::cli
