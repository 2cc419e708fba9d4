// Queues of rays (shaders/tracing/ray_queue.glsl): what a ray meets depends neither on the lane that it falls
// to nor on where a dispatch ends and the next goes on.
#include "render/ray_queue.h"

#include <gtest/gtest.h>

#include "render/ray_caster.h"
#include "render/renderer.h"
#include "render/renderer_state.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

using namespace testing;

/// Triangles in a row under instances that overlap, before a wall of the world's own.
Scene instanced_soup() {
  Scene scene = random_soup(40, 7);
  scene.meshes.push_back(random_soup(150, 8).meshes[0]);
  Object object;
  object.shapes.push_back(mesh_shape(1));
  scene.objects.push_back(object);
  for (int i = 0; i < 9; ++i) {
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1), glm::dvec3(0.4 * i - 1.6, 0.3 * (i % 3), 0.5 * (i % 2)));
    scene.instances.push_back(
        {0, glm::scale(glm::rotate(moved, 0.5 * i, glm::dvec3(0, 1, 0)), glm::dvec3(0.4))});
  }
  return scene;
}

/// Slivers along the diagonals of a cube: every box holds much of it, and hardly a ray meets one.
Scene slivers(int count) {
  Scene scene = random_soup(0, 1, 16, 16);
  TriangleMesh mesh;
  mesh.positions = {{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}};
  for (int i = 0; i < count; ++i) {
    const auto random = [&](int k) { return uniform64(5, i, k); };
    const glm::vec3 from(4 * random(0) - 2, 4 * random(1) - 2, 2 - 4 * random(2));
    mesh.positions.push_back(from);
    mesh.positions.push_back(-from + glm::vec3(1e-4f * random(3)));
    mesh.positions.push_back(from + glm::vec3(1e-4f, 0, 0));
  }
  for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); i += 3)
    mesh.triangles.emplace_back(i, i + 1, i + 2);
  scene.meshes[0] = mesh;
  return scene;
}

std::vector<float> image(const Scene& scene, const AmbientOcclusionJob& job, const RendererOptions& options) {
  return Renderer(scene, options).render(job).image.pixels;
}

RendererOptions options(const char* fetch, std::uint32_t iterations = RendererOptions().queue_iterations) {
  RendererOptions o;
  o.device = "lavapipe";
  o.fetch = fetch;
  o.instancing = "two-level";
  o.queue_iterations = iterations;
  return o;
}

AmbientOcclusionJob job(const char* sampler, std::uint32_t samples) {
  AmbientOcclusionJob j;
  j.sampler = sampler;
  j.samples = samples;
  return j;
}

// The kernel that reads storage buffers has one ray a lane.
TEST(RayQueue, ImagesHaveTheSameBitsWithAndWithoutIt) {
  for (const Scene& scene : {random_soup(3000, 3, 31, 23), round_things(), instanced_soup()}) {
    for (const AmbientOcclusionJob& j : {job("random", 1), job("capcon-domain", 16), job("sobol-owen", 25)}) {
      const std::vector<float> expected = image(scene, j, options("storage"));
      for (const std::uint32_t iterations : {1u, 37u, 16384u})
        EXPECT_EQ(image(scene, j, options("texel", iterations)), expected)
            << scene.name << ", " << j.sampler << ", " << iterations << " iterations";
    }
  }
}

// lavapipe ends an invocation after 65,535 iterations without a word: some hundred rays with thousands each
// would take more.
TEST(RayQueue, LongWalksAreNotCutShort) {
  const Scene scene = slivers(6000);
  const AmbientOcclusionJob j = job("random", 128);
  EXPECT_EQ(image(scene, j, options("texel")), image(scene, j, options("texel", 1)));
}

TEST(RayQueue, AnyNumberOfRaysIsAnswered) {
  Renderer renderer(random_soup(3000, 4), options("texel"));
  std::vector<DeviceRay> rays;
  for (int i = 0; i < 3000; ++i) {
    const auto random = [&](int k) { return uniform64(6, i, k); };
    const glm::vec3 d(2 * random(3) - 1, 2 * random(4) - 1, 2 * random(5) - 1);
    const glm::vec3 o(3 * random(0) - 1.5, 3 * random(1) - 1.5, 3 * random(2) - 1.5);
    rays.push_back({o, i % 3 == 0 ? 0.7f : 3e38f, glm::normalize(d)});
  }
  for (const std::size_t count : {1, 7, 8, 9, 16, 17, 511, 513, 3000}) {
    RayCaster caster(renderer.state(), std::span(rays).first(count));
    caster.cast(false);
    const std::vector<DeviceHit> closest = caster.hits();
    caster.cast(true);
    const std::vector<DeviceHit> any = caster.hits();
    std::size_t met = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const bool meets = closest[i].primitive != layout::kNoPrimitive;
      met += meets ? 1 : 0;
      EXPECT_EQ(any[i].primitive != layout::kNoPrimitive, meets) << "ray " << i << " of " << count;
    }
    if (count == 3000) {
      EXPECT_GT(met, 300u);
      EXPECT_LT(met, 2700u);
    }
  }
}

}  // namespace
}  // namespace capcon
