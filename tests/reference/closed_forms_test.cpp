// Ambient occlusion where the integral is known: form factors of a differential area (Howell, "A Catalog of
// Radiation Heat Transfer Configuration Factors").
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/reference.h"
#include "reference/scenes.h"

namespace capcon {
namespace {

using test::Builder;
using test::move;

AmbientOcclusionJob job_of(std::uint32_t samples, double radius = std::numeric_limits<double>::infinity()) {
  AmbientOcclusionJob job;
  job.sampler = "sobol-owen";
  job.samples = samples;
  job.radius = radius;
  job.seed = 7;
  return job;
}

/// The mean over a small image all of whose pixels see the same point.
double mean(const Scene& scene, const AmbientOcclusionJob& job) {
  const Image image = Reference(scene).render(job).image;
  double sum = 0;
  for (float v : image.pixels) sum += v;
  return sum / double(image.pixels.size());
}

TEST(ClosedForms, APlaneAloneIsFullyVisible) {
  // Also far from the origin and in any direction: no surface occludes itself.
  for (const float size : {1e-3f, 1.0f, 1e6f}) {
    Builder b(8, 8);
    b.quad({-size, size / 3, -size}, {2 * size, size / 7, 0}, {0, size / 5, 2 * size});
    b.camera({0, 9.0 * size, 0}, {0.01, -1, 0.02}, 5);
    const Image image = Reference(b.scene).render(job_of(64)).image;
    for (float v : image.pixels) ASSERT_EQ(v, 1) << "size " << size;
  }
}

TEST(ClosedForms, NothingSeenIsZero) {
  Builder b;
  test::floor(b, 1).camera({0, 1, 0}, {0, 1, 0});
  const RenderResult result = Reference(b.scene).render(job_of(4));
  for (float v : result.image.pixels) EXPECT_EQ(v, 0);
  EXPECT_EQ(result.rays, 0u);
  Builder empty;
  EXPECT_EQ(mean(empty.scene, job_of(4)), 0);
}

TEST(ClosedForms, AnInfiniteWallTakesHalf) {
  // A wall seen from just before its foot covers half of the projected hemisphere.
  Builder b(8, 8);
  test::floor(b, 1e5f).quad({-1e5f, 0, 0}, {2e5f, 0, 0}, {0, 1e5f, 0});
  b.camera({0, 1, -1e-3}, {0, -1, 0}, 1e-6);
  EXPECT_NEAR(mean(b.scene, job_of(256)), 0.5, 2e-3);
}

TEST(ClosedForms, AnInfiniteWallAtADistance) {
  // A wall of height h at distance d: F = (1 - d / sqrt(d^2 + h^2)) / 2.
  Builder b(8, 8);
  test::floor(b, 1e4f).quad({-1e4f, 0, 0.75f}, {2e4f, 0, 0}, {0, 1, 0});
  b.camera({0, 0.5, 0}, {0, -1, 0});
  EXPECT_NEAR(mean(b.scene, job_of(1024)), 1 - 0.5 * (1 - 0.6), 1e-3);
}

TEST(ClosedForms, AParallelDiskConverges) {
  // Over the centre: F = R^2 / (R^2 + h^2) = 0.36.
  Builder b(8, 8);
  test::floor(b, 100).disk(0.75, 0, 0, glm::rotate(move(0, 1, 0), 0.5 * M_PI, glm::dvec3(1, 0, 0)));
  b.camera({0, 0.5, 0}, {0, -1, 0});
  const auto rmse = [&](std::uint32_t samples) {
    const Image image = Reference(b.scene).render(job_of(samples)).image;
    double sum = 0;
    for (float v : image.pixels) sum += (v - 0.64) * (v - 0.64);
    return std::sqrt(sum / double(image.pixels.size()));
  };
  EXPECT_NEAR(mean(b.scene, job_of(1024)), 0.64, 1e-3);
  const double coarse = rmse(16);
  EXPECT_LT(rmse(1024), coarse / 8);  // more than the 1 / 8 of independent points
  EXPECT_LT(coarse, 0.12);
}

TEST(ClosedForms, ARingIsTheDifferenceOfTwoDisks) {
  Builder b(8, 8);
  test::floor(b, 100).disk(0.75, 1, 0.5, glm::rotate(glm::dmat4(1), -0.5 * M_PI, glm::dvec3(1, 0, 0)));
  b.camera({0, 0.5, 0}, {0, -1, 0});
  EXPECT_NEAR(mean(b.scene, job_of(1024)), 1 - (0.36 - 0.2), 1e-3);
}

TEST(ClosedForms, ASphereOverhead) {
  // F = (R / d)^2 while the sphere is above the horizon; off the normal by theta: F = cos(theta) (R / d)^2.
  Builder above(8, 8);
  test::floor(above, 100).sphere(0.6, move(0, 1, 0));
  above.camera({0, 0.2, 0}, {0, -1, 0});
  EXPECT_NEAR(mean(above.scene, job_of(1024)), 0.64, 1e-3);
  Builder aside(8, 8);
  test::floor(aside, 100).sphere(0.5, move(0.6, 0.8, 0));
  aside.camera({0, 0.2, 0}, {0, -1, 0});
  EXPECT_NEAR(mean(aside.scene, job_of(1024)), 1 - 0.8 * 0.25, 1e-3);
}

TEST(ClosedForms, ASphereFromOutsideAndInside) {
  // A convex surface never occludes itself; from inside it covers everything.
  Builder b(8, 8);
  b.sphere(3, glm::scale(move(5, -2, 1), glm::dvec3(1, 0.5, 2)));
  b.camera({5, 6, 1}, {0, -1, 0}, 20);
  const Image outside = Reference(b.scene).render(job_of(64)).image;
  for (float v : outside.pixels) ASSERT_EQ(v, 1);
  b.camera({5, -2, 1}, {0.3, -1, 0.4}, 60);
  const Image inside = Reference(b.scene).render(job_of(64)).image;
  for (float v : inside.pixels) ASSERT_EQ(v, 0);
}

TEST(ClosedForms, TheRadiusLimitsOccluders) {
  Builder b(8, 8);
  test::floor(b, 100).quad({-100, 1, -100}, {200, 0, 0}, {0, 0, 200});
  b.camera({0, 0.5, 0}, {0, -1, 0});
  // A parallel plane at height 1 is within r of the point where cos(theta) >= 1 / r: AO = 1 - (1 - 1 / r^2).
  EXPECT_EQ(mean(b.scene, job_of(64, 0.999)), 1);
  EXPECT_NEAR(mean(b.scene, job_of(1024, 2.0)), 0.25, 1e-3);
  EXPECT_NEAR(mean(b.scene, job_of(1024, 4.0)), 0.0625, 1e-3);
}

TEST(ClosedForms, AClosedBoxSeesNothing) {
  Builder b(16, 16);
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 2.1f : -1.3f, i & 2 ? 1.7f : -0.9f, i & 4 ? 3.3f : -2.9f);
  b.mesh(corners, {{0, 1, 3},
                   {0, 3, 2},
                   {4, 6, 7},
                   {4, 7, 5},
                   {0, 2, 6},
                   {0, 6, 4},
                   {1, 5, 7},
                   {1, 7, 3},
                   {0, 4, 5},
                   {0, 5, 1},
                   {2, 3, 7},
                   {2, 7, 6}});
  b.camera({0, 0, 0}, {0.5, -0.4, 1}, 120);  // looks into a corner
  const Image image = Reference(b.scene).render(job_of(64)).image;
  for (float v : image.pixels) ASSERT_EQ(v, 0);
}

}  // namespace
}  // namespace capcon
