// Instant global illumination against anchor scene D of pbrt-v2.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "image/compare.h"
#include "reference/reference.h"
#include "render/features.h"
#include "render/renderer.h"

namespace capcon::bench {

/// As the scene's own file has it: 128 paths, glimit 10, 4 gather samples; VPLs that shine to both sides.
inline GlobalIlluminationJob job_of_d(const std::string& sampler, std::uint32_t sets, std::uint32_t seed) {
  GlobalIlluminationJob job;
  job.sampler = sampler;
  job.direct.sampler = "sobol-xor";
  job.direct.integrator_samples = 64;
  job.direct.seed = seed;
  job.paths = 128;
  job.sets = sets;
  job.limit = 10;
  job.gather = 4;
  job.two_sided = true;
  return job;
}

/// How many pixels of the device's image are farther than 1e-4, relative, from the reference's with the same
/// VPLs.
inline void agreement_with_reference(const Scene& scene, const GlobalIlluminationJob& job) {
  RendererOptions options;
  options.shading = true;
  Renderer renderer(scene, options);
  const Image device = renderer.render(job).image;
  const Image oracle = Reference(scene).render(job, renderer.virtual_lights(job)).image;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < oracle.pixels.size(); i += 3) {
    double most = 0, error = 0;
    for (int c = 0; c < 3; ++c) {
      const double a = device.pixels[i + c], b = oracle.pixels[i + c];
      most = std::max(most, b);
      error = std::max(error, std::abs(a - b));
    }
    beyond += !(error <= 1e-4 * most);
  }
  fmt::print("  {} of {} pixels beyond 1e-4\n", beyond, oracle.pixels.size() / 3);
}

/// `what`: "r" the rows of sets 1 ... 16, "c" the converged image, "a" agreement with the reference.
inline void bench_d(const std::filesystem::path& folder, const std::string& what) {
  if (what.find('a') != std::string::npos) {
    const Scene scene = read_scene((folder / "D.pbrt").string(), needed_reading(DirectLightingJob{}, false));
    GlobalIlluminationJob job = job_of_d("capcon", 4, 1);
    job.direct.integrator_samples = 4;
    job.two_sided = false;
    for (const Clamping clamping : {Clamping::none, Clamping::clamp, Clamping::compensate}) {
      job.clamping = clamping;
      agreement_with_reference(scene, job);
    }
  }
  const Image reference = read_exr(folder / "ref/D_igi_centre_ref_256sets.exr");
  RendererOptions options;
  options.shading = true;
  Renderer renderer(read_scene((folder / "D.pbrt").string(), needed_reading(DirectLightingJob{}, false)),
                    options);
  constexpr std::uint32_t kSeeds = 8;
  if (what.find('r') != std::string::npos) {
    fmt::print("D, mean (least, most) MSE of {} seeds against pbrt-v2's image of 256 sets\n", kSeeds);
    for (const char* sampler : {"sobol-xor", "sobol-owen", "capcon", "capcon-domain"}) {
      for (std::uint32_t sets = 1; sets <= 16; sets *= 2) {
        double sum = 0, trimmed = 0, clamped = 0, least = 1e30, most = 0;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
          const Comparison c = compare(renderer.render(job_of_d(sampler, sets, seed)).image, reference);
          sum += c.mse / kSeeds;
          clamped += c.mse_clamped / kSeeds;
          trimmed += c.mse_trimmed / kSeeds;
          least = std::min(least, c.mse);
          most = std::max(most, c.mse);
        }
        fmt::print("  {:14} {:2} sets: {:.2e} ({:.2e} to {:.2e}), clamped {:.2e}, trimmed {:.2e}\n", sampler,
                   sets, sum, least, most, clamped, trimmed);
        std::fflush(stdout);
      }
    }
  }
  if (what.find('c') == std::string::npos) return;
  for (const bool two_sided : {true, false}) {
    GlobalIlluminationJob job = job_of_d("sobol-owen", 256, 1);
    job.gather = 1;
    job.two_sided = two_sided;
    const Comparison c = compare(renderer.render(job).image, reference);
    fmt::print("  256 sets, {}: {:.2e}, trimmed {:.2e} (below 1e-4), mean difference {:.1e}\n",
               two_sided ? "two-sided" : "one-sided", c.mse, c.mse_trimmed, c.mean_difference);
    std::fflush(stdout);
  }
}

}  // namespace capcon::bench
