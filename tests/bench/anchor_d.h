// Instant global illumination against anchor scene D of pbrt-v2.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "image/compare.h"
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

/// `what`: "r" the rows of sets 1 ... 16, "c" the converged image.
inline void bench_d(const std::filesystem::path& folder, const std::string& what) {
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
