#include "render/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layout.h"
#include "render/features.h"
#include "render/renderer.h"
#include "render/renderer_state.h"

namespace capcon {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) * 1e-6);
}

/// Of a scene that was read with everything.
struct Contents {
  std::uint64_t normals = 0, uvs = 0, image_bytes = 0;
  std::size_t texture_images = 0, environments = 0;
};

Contents contents(const Scene& scene) {
  Contents c;
  for (const TriangleMesh& mesh : scene.meshes) {
    c.normals += mesh.normals.size();
    c.uvs += mesh.uvs.size();
  }
  for (const SceneImage& image : scene.images) c.image_bytes += 4 * image.image.pixels.size();
  for (const Entity& texture : scene.textures) c.texture_images += texture.image >= 0;
  for (const Entity& light : scene.lights) c.environments += light.image >= 0;
  return c;
}

std::uint64_t memory_of(const Scene& scene) {
  std::uint64_t bytes = 0;
  for (const TriangleMesh& m : scene.meshes) {
    bytes += 12 * (m.positions.size() + m.triangles.size() + m.normals.size()) + 8 * m.uvs.size();
  }
  for (const SceneImage& image : scene.images) bytes += 4 * image.image.pixels.size();
  return bytes;
}

/// Names of the bits that are set, and of those that are not.
template <std::size_t N>
std::pair<std::string, std::string> names_of(std::uint32_t bits, const std::array<const char*, N>& names) {
  std::string set, unset;
  for (std::size_t i = 0; i < N; ++i) {
    std::string& list = (bits >> i) & 1 ? set : unset;
    list += (list.empty() ? "" : ", ") + std::string(names[i]);
  }
  return {set.empty() ? "none" : set, unset};
}

/// What the kernels of direct lighting are specialised for.
void add_shading_rows(const Constants& constants, std::vector<FeatureRow>& rows) {
  static constexpr std::array kMaterials = {
      "diffuse",  "conductor", "plastic (added)", "plastic (substrate)", "plastic (transmitted)",
      "measured", "textured"};
  static constexpr std::array kLights = {
      "disk", "sphere", "rectangle", "mesh", "environment", "constant environment", "distant", "point"};
  const auto row = [&](const char* name, const std::pair<std::string, std::string>& names) {
    rows.push_back(
        {name, names.first, names.second.empty(), names.second.empty() ? "" : "code for " + names.second});
  };
  row("kinds of material", names_of(constants.at(layout::kSpecMaterials), kMaterials));
  row("kinds of light", names_of(constants.at(layout::kSpecLightKinds), kLights));
}

std::vector<FeatureRow> feature_rows(const Scene& scene, const Features& needed, const Constants& constants) {
  const auto bits = [&](std::uint32_t id) {
    const auto found = constants.find(id);
    return found == constants.end() ? 0 : found->second;
  };
  const bool textures = (bits(layout::kSpecMaterials) & layout::kHasTexture) != 0;
  const bool maps = (bits(layout::kSpecLightKinds) >> layout::kLightMap & 1) != 0;
  const Contents c = contents(scene);
  const auto named = [](std::uint64_t count, const char* one, const char* many) {
    return count == 0 ? fmt::format("no {}", many) : fmt::format("{} {}", count, count == 1 ? one : many);
  };
  return {
      {"normals", named(c.normals, "vertex with a normal", "vertices with normals"),
       bits(layout::kSpecDetailNormals) != 0,
       fmt::format("{} not kept, not uploaded", megabytes(12 * c.normals))},
      {"uvs", named(c.uvs, "vertex with uv", "vertices with uvs"), bits(layout::kSpecDetailUvs) != 0,
       fmt::format("{} not kept, not uploaded", megabytes(8 * c.uvs))},
      {"materials", named(scene.materials.size(), "material", "materials"), needed.shading,
       "not uploaded, no shading kernel code"},
      {"textures",
       fmt::format("{}, {}", named(scene.textures.size(), "texture", "textures"),
                   named(c.texture_images, "image file found", "image files found")),
       textures, "no file opened, nothing uploaded"},
      {"environment", named(c.environments, "environment map", "environment maps"), maps,
       fmt::format("no file opened; with textures {} not read, not uploaded", megabytes(c.image_bytes))},
      {"lights",
       fmt::format("{}, {}", named(scene.lights.size(), "light", "lights"),
                   named(scene.area_lights.size(), "area light", "area lights")),
       needed.shading, "not uploaded"},
      {"spheres and disks", needed.quadrics ? "some" : "none", needed.quadrics,
       "their test compiled out of every walk"},
      {"instances", named(scene.instances.size(), "instance", "instances"), needed.two_level,
       "one level of tree, the second compiled out"},
      {"image samples", needed.jittered ? "jittered" : "pixel centres", needed.jittered,
       "the sampler compiled out of the primary kernel"},
  };
}

double device_seconds(const RenderResult& result) {
  double sum = 0;
  for (const auto& [stage, s] : result.timings.device) sum += s;
  return sum;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

/// One of the two ways.
struct Contender {
  Cost cost;
  std::unique_ptr<Renderer> renderer;
  std::vector<double> seconds;
  std::vector<float> pixels;

  Contender(const Scene& scene, RendererOptions options, bool keep_everything, const Job& job) {
    options.keep_everything = keep_everything;
    renderer = std::make_unique<Renderer>(scene, options, open_device(options), &job);
    const auto& wall = renderer->setup().wall;
    cost.build_seconds = wall.at("build");
    cost.upload_seconds = wall.at("upload");
    cost.scene_bytes = memory_of(scene);
    for (const auto& [name, bytes] : renderer->state().buffer_bytes()) {
      if (bytes > 16) cost.device_bytes += bytes;
    }
  }

  void run(const Job& job) {
    RenderResult result = renderer->render(job);
    if (pixels.empty()) cost.compile_seconds = result.timings.wall.at("compile");
    seconds.push_back(device_seconds(result));
    pixels = std::move(result.image.pixels);
    cost.device_seconds = median(seconds);
  }
};

nlohmann::ordered_json to_json(const Cost& c) {
  return {{"read_seconds", c.read_seconds},     {"build_seconds", c.build_seconds},
          {"upload_seconds", c.upload_seconds}, {"compile_seconds", c.compile_seconds},
          {"device_seconds", c.device_seconds}, {"scene_bytes", c.scene_bytes},
          {"device_bytes", c.device_bytes}};
}

Scene read(const std::string& path, int width, int height, const Job& job, bool everything, double& seconds) {
  const auto start = Clock::now();
  Scene scene = read_scene(path, needed_reading(job, everything));
  seconds = seconds_since(start);
  if (width > 0) scene.film.width = width;
  if (height > 0) scene.film.height = height;
  return scene;
}

}  // namespace

Explanation explain(const std::string& scene_path, int width, int height, const Job& job,
                    const RendererOptions& options, int repeats) {
  Explanation e;
  e.repeats = repeats;
  double read_needed = 0, read_everything = 0;
  const Scene lean = read(scene_path, width, height, job, false, read_needed);
  const Scene whole = read(scene_path, width, height, job, true, read_everything);
  Contender needed(lean, options, false, job), everything(whole, options, true, job);
  for (int r = 0; r < repeats; ++r) {
    needed.run(job);
    everything.run(job);
  }
  std::vector<double> ratios;
  for (int r = 0; r < repeats; ++r) ratios.push_back(needed.seconds[r] / everything.seconds[r]);
  e.device_ratio = median(ratios);
  e.device_ratio_low = *std::min_element(ratios.begin(), ratios.end());
  e.device_ratio_high = *std::max_element(ratios.begin(), ratios.end());
  e.identical = needed.pixels == everything.pixels;
  e.needed = needed.cost;
  e.everything = everything.cost;
  e.needed.read_seconds = read_needed;
  e.everything.read_seconds = read_everything;
  e.rows = feature_rows(whole, needed.renderer->state().features, needed.renderer->state().scene_constants);
  if (needs_shading(job)) add_shading_rows(needed.renderer->state().scene_constants, e.rows);
  return e;
}

nlohmann::ordered_json to_json(const Explanation& e) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const FeatureRow& row : e.rows) {
    rows.push_back({{"name", row.name}, {"in_scene", row.in_scene}, {"used", row.used}});
    if (!row.used) rows.back()["left_out"] = row.left_out;
  }
  return {{"features", rows},
          {"needed", to_json(e.needed)},
          {"everything", to_json(e.everything)},
          {"device_ratio",
           {{"median", e.device_ratio}, {"low", e.device_ratio_low}, {"high", e.device_ratio_high}}},
          {"repeats", e.repeats},
          {"identical", e.identical}};
}

std::string to_text(const Explanation& e) {
  std::string text;
  for (const FeatureRow& row : e.rows) {
    text += fmt::format("{:18} {:44} {}\n", row.name, row.in_scene,
                        row.used ? "used" : "left out: " + row.left_out);
  }
  text += fmt::format("\n{:34} {:>12} {:>16} {:>12}\n", "", "as needed", "keep everything", "saved");
  const auto row = [&](const char* name, double a, double b, double scale, const char* unit) {
    text += fmt::format("{:34} {:>9.1f} {:2} {:>13.1f} {:2} {:>9.1f} {:2}\n", name, a * scale, unit,
                        b * scale, unit, (b - a) * scale, unit);
  };
  const auto bytes = [&](const char* name, std::uint64_t a, std::uint64_t b) {
    row(name, static_cast<double>(a), static_cast<double>(b), 1e-6, "MB");
  };
  bytes("scene in memory", e.needed.scene_bytes, e.everything.scene_bytes);
  bytes("buffers on the device", e.needed.device_bytes, e.everything.device_bytes);
  row("reading", e.needed.read_seconds, e.everything.read_seconds, 1e3, "ms");
  row("building", e.needed.build_seconds, e.everything.build_seconds, 1e3, "ms");
  row("uploading", e.needed.upload_seconds, e.everything.upload_seconds, 1e3, "ms");
  row("compiling (while building)", e.needed.compile_seconds, e.everything.compile_seconds, 1e3, "ms");
  row("device, median", e.needed.device_seconds, e.everything.device_seconds, 1e3, "ms");
  text += fmt::format(
      "\nDevice time as needed / with everything: {:.3f} ({:.3f} to {:.3f} in {} interleaved repeats).\n",
      e.device_ratio, e.device_ratio_low, e.device_ratio_high, e.repeats);
  text += e.identical ? "The two images are the same, bit by bit.\n"
                      : "THE TWO IMAGES DIFFER: this is a defect, please report it.\n";
  return text;
}

}  // namespace capcon
