// Direct lighting: which point goes where.
#include <gtest/gtest.h>

#include "reference/lighting.h"
#include "reference/pixel_filter.h"
#include "sampling/choice.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

using test::direct_job;
using test::kFloor;
using test::lamp;
using test::look_at_origin;
using test::matte;

const std::string kSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";

TEST(DirectLighting, SampleAddressesAreAsAgreed) {
  // A white floor under a white sky, half of which a black wall hides: each sample is worth 1 or 0 by the
  // sign of its disk's x. Two skies: pairs 3 and 4.
  const std::string wall = matte(0) +
                           "Shape \"trianglemesh\" \"point3 P\" [1e-3 -50 0 1e-3 50 0 1e-3 50 90 1e-3 -50 "
                           "90] \"integer indices\" [0 1 2 0 2 3]\n";
  Scene scene = look_at_origin(matte(1) + kFloor + wall + kSky + kSky, 3, {-0.5, 0.2, 0.7});
  const Reference reference(scene);
  DirectLightingJob job = direct_job(4);
  job.sampler = "random";
  job.image_samples = 3;
  for (const bool partition : {true, false}) {
    job.partition = partition;
    const auto sampler =
        partition ? make_sampler("random", 12, job.seed, 3) : make_sampler("random", 4, job.seed);
    const auto open = [&](std::uint32_t pixel, std::uint32_t pair) {
      int count = 0;
      for (std::uint32_t p = 0; p < 3; ++p) {
        for (std::uint32_t i = 0; i < 4; ++i) {
          const FixedPoint u = partition ? sampler->sample(pixel, 4 * p + i, pair, SampleDomain::disk)
                                         : sampler->sample(pixel, i, pair + 65536 * p, SampleDomain::disk);
          count += u.x < 0x80000000u;
        }
      }
      return count;
    };
    job.strategy = Strategy::lights;
    const Image lights = reference.render(job).image;
    job.strategy = Strategy::bsdf;
    const Image bsdf = reference.render(job).image;
    for (std::uint32_t pixel = 0; pixel < 9; ++pixel) {
      EXPECT_NEAR(lights.at(int(pixel % 3), int(pixel / 3), 0), (open(pixel, 3) + open(pixel, 4)) / 12.0,
                  1e-6)
          << partition;
      EXPECT_NEAR(bsdf.at(int(pixel % 3), int(pixel / 3), 0), 2 * open(pixel, 0) / 12.0, 1e-6) << partition;
    }
  }
}

TEST(DirectLighting, EachImageSampleHasItsOwnPart) {
  // As above, but only the half y < 0 of the one pixel's view is floor; through the rest the sky is seen.
  const std::string wall = matte(0) +
                           "Shape \"trianglemesh\" \"point3 P\" [2 -9e4 0 2 9e4 0 2 9e4 9e4 2 -9e4 9e4] "
                           "\"integer indices\" [0 1 2 0 2 3]\n";
  Scene scene = test::parse_world(matte(1) + test::within("Translate 0 -50 0 " + kFloor) + wall + kSky);
  scene.film = {1, 1, ""};
  scene.camera = test::camera_at({0, 0, 1}, {0, 0, -1}, 90);
  const glm::dmat4& m = scene.camera.camera_to_world;
  const Reference reference(scene);
  DirectLightingJob job = direct_job(4, Strategy::lights);
  job.sampler = "random";  // of a net's part just half of the points lie on either side
  job.image_samples = 8;
  job.position = PixelPosition::jittered;
  for (job.seed = 1; job.seed < 9; ++job.seed) {
    const auto places = make_sampler(job.sampler, 8, job.seed),
               points = make_sampler(job.sampler, 32, job.seed, 8);
    double value = 0;
    for (std::uint32_t p = 0; p < 8; ++p) {
      const FixedPoint place = places->sample(0, p, 1);
      const double x = 2 * (place.x / 4294967296.0) - 1, y = 1 - 2 * (place.y / 4294967296.0);
      const bool floor = m[0][1] * x + m[1][1] * y < 0;
      for (std::uint32_t i = 0; i < 4; ++i)
        value += !floor || points->sample(0, 4 * p + i, 3, SampleDomain::disk).x < 0x80000000u;
    }
    EXPECT_NEAR(reference.render(job).image.at(0, 0, 0), value / 32, 1e-6) << job.seed;
  }
}

TEST(DirectLighting, TheComponentIsChosenByItsOwnNumber) {
  // A smooth mirror over a base, before a sky that is black but for the mirror direction's half: samples of
  // the base alone are worth the same each, those of the coat another: count the former.
  Scene scene = look_at_origin(
      "Material \"substrate\" \"rgb Kd\" [1 1 1] \"rgb Ks\" [0.5 0.5 0.5] \"float uroughness\" 1e-6 \"float "
      "vroughness\" 1e-6 \"bool remaproughness\" false " +
          kFloor + kSky,
      2);
  DirectLightingJob job = direct_job(1, Strategy::bsdf);
  job.sampler = "random";
  const Image image = Reference(scene).render(job).image;
  // S = 0.5 + 0.5 (1 - o.z)^5, B = 1 - S.
  const double s = 0.5 + 0.5 * std::pow(1 - 0.8 / std::sqrt(0.7 * 0.7 + 0.4 * 0.4 + 0.8 * 0.8), 5);
  for (std::uint32_t pixel = 0; pixel < 4; ++pixel) {
    const double choice = (component_choice(job.seed, pixel, 0, 0, Split(), false) >> 8) / 16777216.0;
    // The coat alone gives F G1 / s = 1 nearly; the base gives less than 28/23 (1 - F0) / (1 - s).
    const double value = image.at(int(pixel % 2), int(pixel / 2), 0);
    if (choice < s) {
      EXPECT_NEAR(value, 1, 1e-3);
    } else {
      EXPECT_GT(std::abs(value - 1), 0.01);
    }
  }
}

TEST(DirectLighting, ImageSamplesGoByTheFilter) {
  // A lit sheet fills the half x < 0 of one pixel's view and beyond: its value counts the image samples
  // there.
  Scene scene = test::parse_world(lamp("Translate -50 0 0 " + kFloor, "\"bool twosided\" true "));
  scene.film = {1, 1, ""};
  scene.camera = test::camera_at({0, 0, 1}, {0, 0, -1}, 90);
  const glm::dmat4& m = scene.camera.camera_to_world;
  ASSERT_NEAR(std::abs(m[0][0]) + std::abs(m[1][0]), 1, 1e-12);
  const Reference reference(scene);
  DirectLightingJob job = direct_job(1);
  job.image_samples = 16;
  const auto sampler = make_sampler(job.sampler, 16, job.seed);
  for (const PixelFilter filter : {PixelFilter::box, PixelFilter::gaussian}) {
    job.filter = filter;
    job.position = PixelPosition::jittered;
    int inside = 0;
    for (std::uint32_t p = 0; p < 16; ++p) {
      const FixedPoint u = sampler->sample(0, p, 1);
      const auto place = [&](std::uint32_t v) {
        return (v >> 8) / 16777216.0 - 0.5;
      };  // both are odd about the centre
      inside += m[0][0] * place(u.x) - m[1][0] * place(u.y) < 0;
    }
    EXPECT_NEAR(reference.render(job).image.at(0, 0, 0), inside / 16.0, 1e-6);
    job.position = PixelPosition::centre;
    const float centre = reference.render(job).image.at(0, 0, 0);
    EXPECT_TRUE(centre == 0 || centre == 1);
  }
}

TEST(DirectLighting, TheGaussianQuantileInvertsItsDistribution) {
  // Against a sum over many slices.
  constexpr int kSlices = 300000;
  const auto density = [](double t) { return std::exp(-2 * t * t) - std::exp(-4.5); };
  double total = 0, below = 0;
  for (int i = 0; i < kSlices; ++i) total += density(-1.5 + 3 * (i + 0.5) / kSlices);
  for (int i = 0; i < kSlices; ++i) {
    if (i % 30000 == 0) {
      EXPECT_NEAR(reference::gaussian_quantile(below / total), -1.5 + 3.0 * i / kSlices, 2e-6);
    }
    below += density(-1.5 + 3 * (i + 0.5) / kSlices);
  }
}

}  // namespace
}  // namespace capcon
