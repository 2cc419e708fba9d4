// The path tracer where the answer is known.
#include <gtest/gtest.h>

#include "reference/global.h"

namespace capcon {
namespace {

using test::Estimate;
using test::lamp;
using test::matte;

PathTracingJob paths(std::uint32_t samples, bool only_indirect = false) {
  PathTracingJob job;
  job.samples = samples;
  job.only_indirect = only_indirect;
  return job;
}

void expect_near(const Estimate& estimate, double expected, double most_error) {
  EXPECT_LT(std::abs(estimate.mean - expected), 4 * estimate.error + 1e-6 * expected) << estimate.mean;
  EXPECT_LT(estimate.error, most_error * expected);
}

TEST(PathTracing, WhatGlowsAllAroundAddsUpToAGeometricSeries) {
  // Every wall emits L and reflects the part rho: L / (1 - rho) all over, of which L is emitted and rho L is
  // direct light.
  for (const double rho : {0.5, 0.9}) {
    for (const std::string& shape :
         {lamp("ReverseOrientation Shape \"sphere\" \"float radius\" 1"), lamp(test::kBox)}) {
      const Scene scene = test::view_of(matte(rho) + shape, {0.1, 0.2, 0.3}, {1, 0.3, 0.1}, 60, 4);
      const Reference reference(scene);
      expect_near(test::over_seeds(reference, paths(32), 64), 1 / (1 - rho), 0.02);
      expect_near(test::over_seeds(reference, paths(32, true), 64), 1 / (1 - rho) - 1 - rho, 0.03);
    }
  }
}

TEST(PathTracing, AConvexBodyHasNoIndirectLight) {
  const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
  const Scene scene = test::view_of(matte(0.8) + "Shape \"sphere\"\n" + sky, {0, 0, 3}, {0, 0, 0}, 20, 4);
  const Reference reference(scene);
  EXPECT_EQ(test::mean_of(reference.render(paths(64, true)).image), 0);
  EXPECT_NEAR(test::mean_of(reference.render(paths(4096)).image), 0.8, 1e-3);
}

TEST(PathTracing, TwoPlatesReflectOneBounceThatLambertsFormulaKnows) {
  // A large floor emits 1 towards a disk of radius a at height h above it; the disk's radiance is rho, and
  // the floor at its foot shows rho a^2 / (a^2 + h^2) of that. Light that goes on is a part rho^2 of it at
  // most.
  const double rho = 0.1, a = 1, h = 2;
  const std::string floor = lamp(
      "Shape \"trianglemesh\" \"point3 P\" [-300 -300 0 300 -300 0 300 300 0 -300 300 0] \"integer indices\" "
      "[0 1 2 0 2 3]");
  const Scene scene = test::view_of(matte(rho) + floor + "Translate 0 0 2 Shape \"disk\"\n", {0.7, -0.4, 0.8},
                                    {0, 0, 0}, 1e-9, 4);
  const Reference reference(scene);
  const Estimate e = test::over_seeds(reference, paths(4096, true), 8);
  const double first = rho * rho * a * a / (a * a + h * h);  // view factor of the disk from the point
  EXPECT_NEAR(e.mean, first, 4 * e.error + rho * rho * first);
  EXPECT_LT(e.error, 0.01 * first);
}

TEST(PathTracing, AgreesWithDirectLightingWhereThereIsNoMore) {
  // A floor alone: all that there is is direct.
  const std::string light = lamp("Translate 1 1 1.5 Shape \"sphere\" \"float radius\" .5") +
                            "LightSource \"point\" \"point3 from\" [-1 0 1]\n" +
                            "LightSource \"infinite\" \"rgb L\" [.2 .2 .2]\n";
  const Scene scene = test::look_at_origin(
      "Material \"plastic\" \"rgb Kd\" [.4 .4 .4] \"rgb Ks\" [.5 .5 .5] " + test::kFloor + light);
  const Reference reference(scene);
  const double direct = test::radiance(scene, test::direct_job(1 << 14)).x;
  // The sphere is no mirror of the floor's light: it reflects by its own material, which only two surfaces
  // see.
  const Estimate all = test::over_seeds(reference, paths(4096), 8);
  const Estimate indirect = test::over_seeds(reference, paths(4096, true), 8);
  EXPECT_NEAR(all.mean - indirect.mean, direct, 4 * std::hypot(all.error, indirect.error) + 1e-3 * direct);
  EXPECT_LT(all.error, 0.01 * direct);
}

TEST(PathTracing, ImageSamplesFillThePixel) {
  // Half of the pixel sees a glowing plate.
  const std::string plate = lamp(
      "Shape \"trianglemesh\" \"point3 P\" [0 -9 0 9 -9 0 9 9 0 0 9 0] \"integer indices\" [0 1 2 0 2 3]",
      "\"bool twosided\" true ");
  const Scene scene = test::view_of(matte(0) + plate, {0, 0, 5}, {0, 0, 0}, 10, 1);
  const Reference reference(scene);
  PathTracingJob job = paths(4096);
  job.position = PixelPosition::jittered;
  EXPECT_NEAR(test::mean_of(reference.render(job).image), 0.5, 0.03);
  job.position = PixelPosition::centre;
  const double centre = test::mean_of(reference.render(job).image);
  EXPECT_TRUE(centre == 0 || centre == 1);
}

}  // namespace
}  // namespace capcon
