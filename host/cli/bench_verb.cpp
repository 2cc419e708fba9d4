#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "bench/scaling_bench.h"
#include "bench/tracer_bench.h"
#include "cli/positive.h"
#include "cli/scaling_output.h"
#include "cli/verbs.h"
#include "plot/picture_file.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string scene;
  TracerBenchOptions bench;
  int width = 0, height = 0;
  bool scaling = false;
  double largest = 1e7;
  std::string output;
  bool json = false, quiet = false;
};

nlohmann::json to_json(const TracerBench& b) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& row : b.rows) {
    rows.push_back({{"rays", row.rays},
                    {"tracer", row.tracer},
                    {"count", row.count},
                    {"cpu_seconds", row.cpu_seconds},
                    {"device_seconds", row.device_seconds},
                    {"rays_per_cpu_second", static_cast<double>(row.count) / median(row.cpu_seconds)},
                    {"ratio_to_embree_single",
                     row.ratios.empty() ? nlohmann::json() : nlohmann::json(median(row.ratios))},
                    {"ratios", row.ratios},
                    {"different", row.different},
                    {"ties", row.ties}});
  }
  return {{"device", b.device},
          {"triangles", b.triangles},
          {"left_out", b.left_out},
          {"build_seconds", b.build_seconds},
          {"embree_build_seconds", b.embree_build_seconds},
          {"bytes_per_triangle", b.bytes_per_triangle},
          {"compile_milliseconds", 1000 * b.compile_seconds},
          {"rows", rows}};
}

void print(const TracerBench& b) {
  fmt::print(
      "{}, {} triangles, tree built in {:.2f} s (Embree: {:.2f}), {:.0f} bytes a triangle, kernels compiled "
      "in {:.0f} ms\n\n",
      b.device, b.triangles, b.build_seconds, b.embree_build_seconds, b.bytes_per_triangle,
      1000 * b.compile_seconds);
  if (b.left_out > 0)
    fmt::print("{} spheres and disks are left out on both sides: Embree has no such shapes\n\n", b.left_out);
  fmt::print("{:<10} {:<14} {:>9} {:>14} {:>22} {:>10} {:>6}\n", "rays", "tracer", "count", "M rays/CPU s",
             "ratio (min-max)", "different", "ties");
  for (const auto& row : b.rows) {
    const std::string ratio = row.ratios.empty()
                                  ? "-"
                                  : fmt::format("{:.3f} ({:.3f}-{:.3f})", median(row.ratios),
                                                *std::min_element(row.ratios.begin(), row.ratios.end()),
                                                *std::max_element(row.ratios.begin(), row.ratios.end()));
    fmt::print("{:<10} {:<14} {:>9} {:>14.2f} {:>22} {:>10} {:>6}\n", row.rays, row.tracer, row.count,
               1e-6 * static_cast<double>(row.count) / median(row.cpu_seconds), ratio, row.different,
               row.ties);
  }
}

void run_scaling(const Options& o) {
  if (!o.output.empty()) plot::check_picture_name(o.output);
  std::vector<ScalingSeries> series;
  {
    Progress progress("casting", 1, o.quiet);
    series = bench_scaling(o.bench, static_cast<std::uint64_t>(o.largest), o.width > 0 ? o.width : 512,
                           o.height > 0 ? o.height : 512, [&](double f) { progress.update(f); });
  }
  if (!o.output.empty()) draw_scaling(series, o.output);
  if (o.json) {
    fmt::print("{}\n", scaling_json(series).dump(2));
  } else {
    print_scaling(series);
  }
}

}  // namespace

void add_bench_verb(CLI::App& app) {
  CLI::App* bench = app.add_subcommand("bench", "Measure speed");
  bench->require_subcommand(1);
  CLI::App* verb =
      bench->add_subcommand("tracer", "Rays per CPU second beside Embree's, on the very same rays");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Everybody casts the same rays in turn, on all threads, repeat by repeat; ratios are of medians' "
      "repeats, beside "
      "rtcIntersect1 (primary,\n"
      "closest hit) and rtcOccluded1 (occlusion, any hit). Ties: the same distance on another triangle.\n"
      "Spheres and disks are left out. With --scaling: how the cost of a ray grows with the number of "
      "triangles: of one surface that gets finer,\nand of instances of one patch.\n"
      "Examples: capcon bench tracer scenes/courtyard.pbrt --radius 2 --json\n"
      "          capcon bench tracer --scaling -o scaling.svg");
  verb->add_option("scene", o->scene, "Scene: .pbrt, .ply or .obj");
  verb->add_option("--radius", o->bench.radius, "Length of the occlusion rays (default: unlimited)")
      ->check(positive_number());
  verb->add_option("--samples", o->bench.samples, "Occlusion rays a pixel")
      ->capture_default_str()
      ->check(CLI::Range(1u, 1024u));
  verb->add_option("--repeats", o->bench.repeats, "Interleaved repeats")
      ->capture_default_str()
      ->check(CLI::Range(1u, 1000u));
  verb->add_option("--width", o->width, "Image width, instead of the scene's")->check(CLI::Range(1, 4096));
  verb->add_option("--height", o->height, "Image height, instead of the scene's")->check(CLI::Range(1, 4096));
  verb->add_option("--device", o->bench.renderer.device,
                   "best, lavapipe, or a number or name of `capcon info`")
      ->capture_default_str();
  verb->add_option("--fetch", o->bench.renderer.fetch, "How kernels read data: auto, texel or storage")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "texel", "storage"}));
  verb->add_option("--instancing", o->bench.renderer.instancing,
                   "auto, flat (one tree over all instances) or two-level; Embree likewise")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "flat", "two-level"}));
  verb->add_flag("--scaling", o->scaling,
                 "10^4, 10^5 ... triangles of one hilly surface, and of its instances, instead of a scene");
  verb->add_option("--largest", o->largest, "With --scaling: the most triangles")
      ->capture_default_str()
      ->check(CLI::Range(1e4, 1e8));
  verb->add_option("-o,--output", o->output, "With --scaling: a plot, .svg or .png");
  verb->add_flag("--json", o->json, "JSON on stdout");
  verb->add_flag("--quiet", o->quiet, "No progress bar");
  verb->callback([o] {
    if (o->scaling != o->scene.empty())
      throw InputError("bench tracer: give a scene or --scaling, one of them");
    if (!o->output.empty() && !o->scaling)
      throw InputError("bench tracer: -o draws what --scaling measures; add --scaling");
    if (o->scaling) return run_scaling(*o);
    Scene scene = read_scene(o->scene);
    if (o->width > 0) scene.film.width = o->width;
    if (o->height > 0) scene.film.height = o->height;
    TracerBench result;
    {
      Progress progress("casting", 1, o->quiet);
      result = bench_tracer(scene, o->bench, [&](double f) { progress.update(f); });
    }
    if (o->json) {
      fmt::print("{}\n", to_json(result).dump(2));
    } else {
      print(result);
    }
  });
}

}  // namespace capcon::cli
