#include "reference/reference.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "reference/scenes.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

using test::Builder;

AmbientOcclusionJob job_of(PixelPosition position) {
  AmbientOcclusionJob job;
  job.sampler = "sobol-owen";
  job.samples = 16;
  job.position = position;
  return job;
}

/// A floor that ends inside the image, with a ball and its shadow.
Scene still_life() {
  Builder b(32, 24);
  test::floor(b, 2).sphere(0.7, test::move(0.3, 0.7, 0));
  b.camera({0, 2, -5}, {0, -0.3, 1}, 50);
  return b.scene;
}

TEST(Reference, TheSampleAddressesAreAsAgreed) {
  // Under a half plane the visibility of a sample is a sign of its direction: recompute pixels from the
  // sampler's bits. The normal is (0, 1, 0), hence the frame t = (1, 0, 0), bt = (0, 0, -1). A wall just
  // beside every point seen, at +x, leaves the samples with disk x < 0, that is u < 1/2; one at +z those with
  // disk y > 0, that is v >= 1/2.
  AmbientOcclusionJob job = job_of(PixelPosition::centre);
  job.sampler = "random";  // a net puts just half of its points on either side, whatever its address
  job.seed = 99;
  const auto sampler = make_sampler(job.sampler, job.samples, job.seed);
  for (const bool at_x : {true, false}) {
    Builder b(5, 3);
    test::floor(b, 1e5f);
    if (at_x) b.quad({1e-3f, 0, -1e5f}, {0, 1e5f, 0}, {0, 0, 2e5f});
    if (!at_x) b.quad({-1e5f, 0, 1e-3f}, {0, 1e5f, 0}, {2e5f, 0, 0});
    b.camera({0, 1, 0}, {0, -1, 0});
    const Image image = Reference(b.scene).render(job).image;
    for (std::uint32_t y = 0; y < 3; ++y) {
      for (std::uint32_t x = 0; x < 5; ++x) {
        int visible = 0;
        for (std::uint32_t i = 0; i < job.samples; ++i) {
          const FixedPoint p = sampler->sample(y * 5 + x, i, 0, SampleDomain::disk);
          visible += at_x ? p.x < 0x80000000u : p.y >= 0x80000000u;
        }
        EXPECT_EQ(image.at(int(x), int(y), 0), float(visible / 16.0)) << at_x << " " << x << " " << y;
      }
    }
  }
}

TEST(Reference, JitteredPositionsComeFromTheirOwnPair) {
  // A floor seen in the part x < 0 of one pixel alone: its value counts the samples of pair 1 on that side.
  Builder b(1, 1);
  b.quad({-100, 0, -100}, {0, 0, 200}, {100, 0, 0}).camera({0, 1, 0}, {0, -1, 0}, 90);
  const double right = b.scene.camera.camera_to_world[0][0];  // does image right point to +x or -x?
  ASSERT_EQ(std::abs(right) + std::abs(b.scene.camera.camera_to_world[1][0]), 1);
  for (std::uint32_t seed : {1u, 2u, 3u}) {
    AmbientOcclusionJob job = job_of(PixelPosition::jittered);
    job.seed = seed;
    job.sampler = "random";
    const auto sampler = make_sampler(job.sampler, job.samples, seed);
    int seen = 0;
    for (std::uint32_t i = 0; i < job.samples; ++i) {
      const FixedPoint p = sampler->sample(0, i, 1);
      const double sx = 2 * (p.x / 4294967296.0) - 1, sy = 1 - 2 * (p.y / 4294967296.0);
      const glm::dmat4& m = b.scene.camera.camera_to_world;
      seen += m[0][0] * sx + m[1][0] * sy < 0;
    }
    const RenderResult result = Reference(b.scene).render(job);
    EXPECT_EQ(result.image.pixels[0], float(seen / 16.0));
    EXPECT_EQ(result.rays, std::uint64_t(seen));
  }
}

TEST(Reference, CentreAndJitteredAgreeInTheMeanButNotAtEdges) {
  const Scene scene = still_life();
  const Reference reference(scene);
  const Image centre = reference.render(job_of(PixelPosition::centre)).image;
  const Image jittered = reference.render(job_of(PixelPosition::jittered)).image;
  double difference = 0;
  int unlike = 0;
  for (std::size_t i = 0; i < centre.pixels.size(); ++i) {
    difference += centre.pixels[i] - jittered.pixels[i];
    unlike += std::abs(centre.pixels[i] - jittered.pixels[i]) > 0.3f;
  }
  EXPECT_LT(std::abs(difference / double(centre.pixels.size())), 0.02);
  EXPECT_GT(unlike, 5);
}

TEST(Reference, SameBitsForAnyNumberOfThreads) {
  const Scene scene = still_life();
  const Reference reference(scene);
  for (const PixelPosition position : {PixelPosition::centre, PixelPosition::jittered}) {
    setenv("CAPCON_THREADS", "1", 1);
    const RenderResult one = reference.render(job_of(position));
    setenv("CAPCON_THREADS", "4", 1);
    const RenderResult four = reference.render(job_of(position));
    unsetenv("CAPCON_THREADS");
    EXPECT_EQ(one.image.pixels, four.image.pixels);
    EXPECT_EQ(one.rays, four.rays);
  }
}

TEST(Reference, InstancesAreCopies) {
  Scene flat = still_life();
  Scene instanced = flat;
  const glm::dmat4 move = test::move(0.5, 0.25, -1);  // exact in floats, as are the vertices
  for (Shape& shape : flat.shapes) shape.to_world = move * shape.to_world;
  instanced.objects.push_back({"all", instanced.shapes});
  instanced.shapes.clear();
  instanced.instances.push_back({0, move});
  const AmbientOcclusionJob job = job_of(PixelPosition::jittered);
  EXPECT_EQ(Reference(flat).render(job).image.pixels, Reference(instanced).render(job).image.pixels);
}

TEST(Reference, ReportsWhatItDid) {
  const Scene scene = still_life();
  const Reference reference(scene);
  double last = 0;
  bool foreign = false;
  const std::thread::id here = std::this_thread::get_id();
  const RenderResult result = reference.render(job_of(PixelPosition::centre), [&](double done) {
    foreign |= std::this_thread::get_id() != here;
    EXPECT_GE(done, last);
    last = done;
  });
  EXPECT_FALSE(foreign);
  EXPECT_EQ(last, 1);
  EXPECT_EQ(result.device, "reference");
  EXPECT_GT(result.rays, 0u);
  EXPECT_EQ(result.rays % 16, 0u);
  EXPECT_GT(result.timings.wall.at("trace"), 0);
  EXPECT_GT(reference.setup().wall.at("build"), 0);
}

}  // namespace
}  // namespace capcon
