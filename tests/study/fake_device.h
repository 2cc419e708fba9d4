#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/hash.h"
#include "study/runner.h"

namespace capcon {

/// A sampler whose error is known: independent normal noise of variance c n^-p in every pixel. It says what
/// time it took: seconds_per_sample * n + a fixed part.
struct FakeLaw {
  double c = 0.2;
  double p = 1;
  double seconds_per_sample = 1e-3;
};

inline FakeLaw fake_law(const std::string& sampler) {
  if (sampler == "random") return {0.2, 1, 1e-3};
  if (sampler == "sobol-xor") return {0.2, 1.25, 1e-3};
  if (sampler == "sobol-owen") return {0.2, 1.25, 2e-3};  // as good, half as fast
  if (sampler == "capcon") return {0.1, 1.25, 1e-3};      // half the error
  return {0.3, 1.1, 1e-3};
}

inline double fake_truth(int x, int y, int width, int height) {
  return 0.5 + 0.4 * std::sin(7.0 * x / width) * std::cos(5.0 * y / height);
}

/// A device of that kind; `renders`, if given, counts its renders.
inline MakeStudyDevice fake_device(int* renders = nullptr) {
  return [renders](int width, int height) {
    const RenderJob render = [=](const Job& any) {
      const auto& job = std::get<AmbientOcclusionJob>(any);
      if (renders) ++*renders;
      const FakeLaw law = fake_law(job.sampler);
      const double sd = std::sqrt(law.c * std::pow(job.samples, -law.p));
      const std::uint64_t stream = fnv1a64(job.sampler) + job.samples;
      RenderResult result;
      result.image = Image(width, height, 1);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const std::uint64_t pixel = 2 * (std::uint64_t(y) * width + x);
          const double u = 1 - uniform64(job.seed, stream, pixel);
          const double v = uniform64(job.seed, stream, pixel + 1);
          const double normal = std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
          result.image.at(x, y, 0) = static_cast<float>(fake_truth(x, y, width, height) + sd * normal);
        }
      }
      result.rays = std::uint64_t(width) * height * job.samples;
      result.device = "fake";
      result.timings.device = {{"primary", 1e-6}, {"occlusion", law.seconds_per_sample * job.samples}};
      result.timings.wall = {{"points", 1e-9}, {"occlusion", 1e-6}};
      return result;
    };
    return StudyDevice{render, {{"name", "fake device"}, {"driver", "none <1 & 2>"}}};
  };
}

inline StudySettings fake_settings() {
  StudySettings s;
  s.scene = "fake <scene>";
  s.width = 40;
  s.height = 25;
  s.radius = 2;
  s.samplers = {"random", "sobol-xor", "sobol-owen", "capcon"};
  s.samples = {1, 2, 4, 8, 16, 32, 64};
  s.seeds = 8;
  s.reference_samples = 4096;
  s.close_ups = false;
  s.command = "capcon study ambient-occlusion fake";
  return s;
}

/// A run whose error is exactly `mse`, for tests of the figures alone.
inline RunRecord exact_run(const std::string& sampler, std::uint32_t samples, std::uint32_t seed, double mse,
                           double device_seconds) {
  RunRecord r;
  r.run = {sampler, samples, seed};
  r.mse = r.mse_trimmed = r.relmse = mse;
  r.device_seconds = device_seconds;
  r.wall_seconds = 2 * device_seconds;
  r.point_generation_seconds = device_seconds / 2;
  r.device = "fake";
  return r;
}

}  // namespace capcon
