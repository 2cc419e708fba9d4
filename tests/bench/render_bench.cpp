// Renders against the anchor scenes' reference images (not part of the project): render_bench FOLDER
// [b|c|dr|dc|da]. Scene B: error at 16 samples of each sampler, and converged. Scene C: what remains,
// material by material, with our materials and with pbrt-v2's own models as tables. Scene D, instant global
// illumination: rows of sets (dr), converged (dc), and the
// device beside the reference with the same virtual lights (da).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "anchor_d.h"
#include "image/compare.h"
#include "pbrt_v2_models.h"
#include "render/features.h"
#include "render/renderer.h"
#include "shading/spectrum.h"

using namespace capcon;

namespace {

DirectLightingJob job_of(const std::string& sampler, std::uint32_t samples, std::uint32_t seed) {
  DirectLightingJob job;
  job.sampler = sampler;
  job.integrator_samples = samples;
  job.seed = seed;
  return job;
}

RendererOptions options() {
  RendererOptions o;
  o.shading = true;
  return o;
}

Scene read(const std::filesystem::path& path) {
  return read_scene(path.string(), needed_reading(DirectLightingJob{}, false));
}

void bench_b(const std::filesystem::path& folder) {
  const Image reference = read_exr(folder / "ref/B_direct_centre_v4.exr");
  Renderer renderer(read(folder / "B.pbrt"), options());
  fmt::print(
      "B, MSE at 16 samples against pbrt-v4's image, mean of seeds 1 to 4 (pbrt-v4: perm 2.62e-5, owen "
      "1.72e-5)\n");
  for (const std::string& sampler : sampler_names()) {
    double sum = 0, trimmed = 0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
      const Comparison c = compare(renderer.render(job_of(sampler, 16, seed)).image, reference);
      sum += c.mse / 4;
      trimmed += c.mse_trimmed / 4;
    }
    fmt::print("  {:14} {:.3e}  trimmed {:.3e}\n", sampler, sum, trimmed);
  }
  const Comparison c = compare(renderer.render(job_of("sobol-owen", 4096, 1)).image, reference);
  fmt::print("  sobol-owen, 4096 samples: {:.3e}, trimmed {:.3e} (below 5e-7)\n", c.mse, c.mse_trimmed);
}

/// Pixels that show a material: those that change when it alone is black.
std::vector<char> mask_of(Scene scene, const Image& whole, std::size_t material) {
  scene.materials[material].type = "matte";
  scene.materials[material].parameters.entries = {{"Kd", {"color", std::vector<double>{0, 0, 0}, {}}}};
  Renderer renderer(scene, options());
  const Image black = renderer.render(job_of("sobol-owen", 16, 1)).image;
  std::vector<char> mask(whole.pixels.size() / 3);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    for (int c = 0; c < 3; ++c) mask[i] |= black.pixels[3 * i + c] != whole.pixels[3 * i + c];
  }
  return mask;
}

constexpr int kSeeds = 4;
constexpr std::uint32_t kSamples = 1024;

Image converged(const Scene& scene) {
  Renderer renderer(scene, options());
  std::vector<double> mean;
  Image image;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    image = renderer.render(job_of("sobol-owen", kSamples, seed)).image;
    mean.resize(image.pixels.size());
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<double>(image.pixels[i]) / kSeeds;
  }
  std::copy(mean.begin(), mean.end(), image.pixels.begin());
  return image;
}

void print_row(const Entity& material, const std::vector<char>& mask, const Image& ours,
               const Image& theirs) {
  std::vector<double> errors;
  double sums[2][3] = {};
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    double error = 0;
    for (int c = 0; c < 3; ++c) {
      const double a = ours.pixels[3 * i + c], b = theirs.pixels[3 * i + c];
      error += (a - b) * (a - b) / 3;
      sums[0][c] += a;
      sums[1][c] += b;
    }
    errors.push_back(error);
  }
  if (errors.empty()) return;
  std::sort(errors.begin(), errors.end());
  const auto mean_of = [&](std::size_t n) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += errors[i];
    return sum / static_cast<double>(n);
  };
  fmt::print(
      "  {:10} line {:3}: {:6} pixels, MSE {:.2e}, trimmed {:.2e}, median {:.2e}, ours/theirs {:.4f} {:.4f} "
      "{:.4f}\n",
      material.type, material.place.line, errors.size(), mean_of(errors.size()),
      mean_of(errors.size() - errors.size() / 100), errors[errors.size() / 2], sums[0][0] / sums[1][0],
      sums[0][1] / sums[1][1], sums[0][2] / sums[1][2]);
}

/// What pbrt-v2 makes of a material, nothing where we do the same.
std::optional<bench::Model> model_of_v2(const Entity& material) {
  const Parameters& p = material.parameters;
  const auto colour = [&](const char* name) {
    const std::vector<double>& v = *p.numbers(name);
    return glm::dvec3(v.at(0), v.at(1), v.at(2));
  };
  if (material.type == "plastic")
    return bench::plastic_of_v2(colour("Kd"), colour("Ks"), p.number("roughness", 0.1));
  if (material.type == "substrate")
    return bench::substrate_of_v2(colour("Kd"), colour("Ks"), p.number("uroughness", 0.1));
  if (material.type == "metal")
    return bench::metal_of_v2(colour("eta"), colour("k"), p.number("roughness", 0.01));
  return {};
}

/// The scene with pbrt-v2's own models, as tables in `folder`.
Scene with_models_of_v2(Scene scene, const std::filesystem::path& folder) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    Entity& material = scene.materials[m];
    const auto model = model_of_v2(material);
    if (!model) continue;
    const std::filesystem::path file = folder / fmt::format("{}.binary", m);
    bench::write_merl(file, *model);
    material.type = "measured";
    material.parameters.entries = {{"filename", {"string", std::vector<std::string>{file.string()}, {}}}};
  }
  return scene;
}

void bench_c(const std::filesystem::path& folder) {
  const Image reference = read_exr(folder / "ref/C_split_centre_ref1024.exr");
  const Scene scene = read(folder / "C.pbrt");
  Renderer renderer(scene, options());
  const Image whole = renderer.render(job_of("sobol-owen", 16, 1)).image;
  std::vector<std::vector<char>> masks;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) masks.push_back(mask_of(scene, whole, m));
  const auto print = [&](const char* title, const Image& ours) {
    const Comparison all = compare(ours, reference);
    fmt::print("C, {}, {} x {} samples: MSE {:.3e}, trimmed {:.3e}\n", title, kSeeds, kSamples, all.mse,
               all.mse_trimmed);
    for (std::size_t m = 0; m < masks.size(); ++m) print_row(scene.materials[m], masks[m], ours, reference);
  };
  print("our materials", converged(scene));
  const std::filesystem::path tables = std::filesystem::temp_directory_path() / "capcon-render-bench";
  std::filesystem::create_directories(tables);
  Image theirs = converged(with_models_of_v2(scene, tables));
  std::filesystem::remove_all(tables);
  // Their spectral colours are not divided by those of white (docs/materials.md).
  const glm::dvec3 white = rgb_of_emission({{500}, {1}});
  for (std::size_t m = 0; m < masks.size(); ++m) {
    for (std::size_t i = 0; i < masks[m].size() && scene.materials[m].type == "measured"; ++i) {
      for (int c = 0; c < 3 && masks[m][i]; ++c) theirs.pixels[3 * i + c] *= static_cast<float>(white[c]);
    }
  }
  print("pbrt-v2's models", theirs);
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    fmt::print(stderr, "usage: render_bench FOLDER [b|c|dr|dc|da], the folder of the anchor scenes\n");
    return 2;
  }
  const std::string which = count > 2 ? words[2] : "bc";
  if (which.starts_with("d")) {
    bench::bench_d(words[1], which.substr(1));
    return 0;
  }
  if (which.find('b') != std::string::npos) bench_b(words[1]);
  if (which.find('c') != std::string::npos) bench_c(words[1]);
  return 0;
}
