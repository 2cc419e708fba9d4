#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "image/compare.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

RendererOptions lavapipe(const char* fetch = "auto") {
  return {.device = "lavapipe", .fetch = fetch, .validate = true};
}

AmbientOcclusionJob job(const std::string& sampler, std::uint32_t samples, double radius) {
  AmbientOcclusionJob j;
  j.sampler = sampler;
  j.samples = samples;
  j.radius = radius;
  return j;
}

/// Same points: the images agree but where a ray grazes an edge. There one occlusion ray decides 1 / samples
/// of a pixel, and one primary ray (a silhouette through a pixel's centre) all of it.
void expect_agreement(const Scene& scene, const AmbientOcclusionJob& j) {
  Renderer renderer(scene, lavapipe());
  const RenderResult device = renderer.render(j);
  const RenderResult oracle = Reference(scene).render(j);
  const Comparison difference = compare(device.image, oracle.image);
  EXPECT_EQ(difference.non_finite, 0u);
  EXPECT_LE(difference.beyond, 0.001 + 1.5 / (scene.film.width * scene.film.height)) << j.sampler;
  EXPECT_LE(std::abs(difference.mean_difference), 1e-3) << j.sampler << ": more than grazing rays differ";
  double mean = 0;
  for (const float v : device.image.pixels) mean += v;
  mean /= static_cast<double>(device.image.pixels.size());
  EXPECT_GT(mean, 0.02) << "the scene shows nothing";
  EXPECT_LT(mean, 0.98) << "nothing is occluded";
}

TEST(AmbientOcclusion, AgreesWithTheReferenceOnASoup) {
  for (const char* sampler : {"random", "jittered", "sobol-xor", "sobol-owen", "ccvt", "capcon"}) {
    expect_agreement(testing::random_soup(700, 1), job(sampler, 16, 1.0));
  }
}

TEST(AmbientOcclusion, AgreesWithTheReferenceOnSpheresAndDisks) {
  expect_agreement(testing::round_things(), job("sobol-owen", 64, 2.0));
  expect_agreement(testing::round_things(), job("capcon", 12, std::numeric_limits<double>::infinity()));
}

TEST(AmbientOcclusion, AgreesWithTheReferenceWhenJittered) {
  auto j = job("capcon", 8, 1.0);
  j.position = PixelPosition::jittered;
  expect_agreement(testing::random_soup(300, 2), j);
  j.sampler = "jittered";
  expect_agreement(testing::round_things(), j);
}

TEST(AmbientOcclusion, AgreesWithTheReferenceOnManyTriangles) {
  expect_agreement(testing::random_soup(20000, 3, 64, 64), job("sobol-xor", 4, 0.2));
}

TEST(AmbientOcclusion, FetchVariantsGiveTheSameBits) {
  for (const Scene& scene : {testing::random_soup(500, 4), testing::round_things()}) {
    Renderer texel(scene, lavapipe("texel")), storage(scene, lavapipe("storage"));
    for (const char* sampler : {"sobol-owen", "capcon"}) {
      EXPECT_EQ(texel.render(job(sampler, 16, 1)).image.pixels,
                storage.render(job(sampler, 16, 1)).image.pixels);
    }
  }
}

TEST(AmbientOcclusion, SameJobSameBitsWhateverRanBetween) {
  const Scene scene = testing::random_soup(500, 5);
  Renderer first(scene, lavapipe()), second(scene, lavapipe());
  const auto a = first.render(job("capcon", 16, 1)).image.pixels;
  second.render(job("random", 3, 0.5));
  second.render(job("capcon", 100, 1));  // a larger table than the next one's
  EXPECT_EQ(a, second.render(job("capcon", 16, 1)).image.pixels);
  auto other = job("capcon", 16, 1);
  other.seed = 2;
  EXPECT_NE(a, second.render(other).image.pixels);
}

// One dispatch holds 2^19 rays: an image whose samples do not fit it is cut into several, with the same sums.
TEST(AmbientOcclusion, ManySamplesAreCutIntoBatches) {
  const Scene scene = testing::random_soup(50, 6, 4, 3);
  Renderer renderer(scene, lavapipe());
  const auto j = job("random", 600000, 1);
  const RenderResult result = renderer.render(j);
  EXPECT_EQ(result.rays, 12u * 600000u);
  const RenderResult oracle = Reference(scene).render(job("random", 20000, 1));
  for (std::size_t i = 0; i < result.image.pixels.size(); ++i) {
    EXPECT_NEAR(result.image.pixels[i], oracle.image.pixels[i], 5 * 0.5 / std::sqrt(20000.0));
  }
}

// A floor below a parallel disk: visible = 1 - R^2 / (R^2 + h^2) under its centre (the form factor of a
// disk).
TEST(AmbientOcclusion, ConvergesToTheClosedFormOfADisk) {
  Scene scene;
  scene.name = "disk";
  scene.film = {1, 1, ""};
  scene.camera = testing::camera_at({0, 0, -3}, 0.001);
  TriangleMesh plane;
  plane.positions = {{-50, -50, 0}, {50, -50, 0}, {0, 90, 0}};
  plane.triangles = {{0, 1, 2}};
  scene.meshes.push_back(plane);
  scene.shapes.push_back(testing::mesh_shape(0));
  Shape disk;
  disk.kind = ShapeKind::disk;
  disk.radius = 1.5;
  disk.to_world = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -4));  // behind the camera, facing the plane
  scene.shapes.push_back(disk);
  Renderer renderer(scene, lavapipe());
  const double expected = 1 - 1.5 * 1.5 / (1.5 * 1.5 + 16);
  const auto infinite = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(renderer.render(job("sobol-owen", 1 << 16, infinite)).image.pixels[0], expected, 5e-5);
  EXPECT_NEAR(renderer.render(job("capcon", 1 << 14, infinite)).image.pixels[0], expected, 5e-4);
  EXPECT_EQ(renderer.render(job("sobol-owen", 64, 3.9)).image.pixels[0], 1.0f)
      << "the disk lies beyond the radius";
}

TEST(AmbientOcclusion, NothingToRenderIsAnInputError) {
  Scene empty;
  empty.film = {4, 4, ""};
  EXPECT_THROW(Renderer(empty, lavapipe()), InputError);
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  Renderer renderer(scene, lavapipe());
  EXPECT_THROW(renderer.render(job("capcon", 0, 1)), InputError);
  EXPECT_THROW(renderer.render(job("capcon", 4, 0)), InputError);
  EXPECT_THROW(renderer.render(job("capcon", 4, std::nan(""))), InputError);
  EXPECT_THROW(Renderer(scene, {.device = "no such device"}), InputError);
}

}  // namespace
}  // namespace capcon
