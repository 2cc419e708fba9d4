#include <gtest/gtest.h>

#include <cmath>

#include "image/compare.h"
#include "reference/reference.h"
#include "render/geometry.h"
#include "render/ray_caster.h"
#include "render/renderer.h"
#include "render/renderer_state.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

/// Instances of three objects, turned, stretched, mirrored, small, large and one squeezed flat, with shapes
/// of the world between them, and a sphere in an object.
Scene instanced_scene(int count, std::uint64_t seed) {
  Scene scene = testing::random_soup(60, seed, 64, 48);
  const auto random = [&](int i, int k) { return uniform64(seed + 100, i, k); };
  for (std::uint64_t o = 0; o < 3; ++o) {
    scene.meshes.push_back(testing::random_soup(o == 0 ? 3 : 200, seed + 1 + o).meshes[0]);
    Object object;
    for (int s = 0; s < 2; ++s) {  // the same mesh twice, the second turned
      Shape shape = testing::mesh_shape(static_cast<std::uint32_t>(scene.meshes.size()) - 1);
      shape.to_world = glm::rotate(glm::dmat4(1), 0.7 * s, glm::dvec3(0, 1, 0));
      object.shapes.push_back(shape);
    }
    scene.objects.push_back(object);
  }
  Shape sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.radius = 0.8;
  scene.objects[1].shapes.push_back(sphere);
  for (int i = 0; i < count; ++i) {
    glm::dmat4 m = glm::translate(
        glm::dmat4(1), glm::dvec3(4 * random(i, 0) - 2, 4 * random(i, 1) - 2, 4 * random(i, 2) - 2));
    m = glm::rotate(m, 6 * random(i, 3),
                    glm::dvec3(random(i, 4) - 0.5, random(i, 5) - 0.5, random(i, 6) - 0.4));
    const double size = 0.02 + 0.4 * random(i, 7) * random(i, 7);
    m = glm::scale(
        m, glm::dvec3(size * (random(i, 8) < 0.5 ? -1 : 1), size * (0.3 + random(i, 9)), i == 0 ? 0 : size));
    scene.instances.push_back({static_cast<std::uint32_t>(i % 3), m});
  }
  return scene;
}

RendererOptions options(const char* instancing, const char* fetch = "auto") {
  return {.device = "lavapipe", .fetch = fetch, .instancing = instancing, .validate = true};
}

AmbientOcclusionJob job(double radius, PixelPosition position = PixelPosition::centre) {
  AmbientOcclusionJob j;
  j.sampler = "sobol-owen";
  j.radius = radius;
  j.position = position;
  return j;
}

TEST(TwoLevels, AgreeWithTheReference) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const Scene scene = instanced_scene(40, seed);
    Renderer renderer(scene, options("two-level"));
    const Reference reference(scene);
    for (const auto& j : {job(0.7), job(1e30, PixelPosition::jittered)}) {
      const Comparison difference = compare(renderer.render(j).image, reference.render(j).image);
      EXPECT_LE(difference.beyond, 0.004) << seed;  // grazing rays and silhouettes of 8,000 small triangles
      EXPECT_LE(std::abs(difference.mean_difference), 1e-3) << seed;
    }
  }
}

// The oracle here is the flat tree: closest hits have the same ids and distances, ray by ray.
TEST(TwoLevels, MeetWhatOneLevelMeets) {
  const Scene scene = instanced_scene(60, 3);
  std::vector<DeviceRay> rays;
  for (int i = 0; i < 20000; ++i) {
    const auto random = [&](int k) { return static_cast<float>(uniform64(9, i, k)); };
    const glm::vec3 from(8 * random(0) - 4, 8 * random(1) - 4, 8 * random(2) - 4);
    const glm::vec3 to(3 * random(3) - 1.5f, 3 * random(4) - 1.5f, 3 * random(5) - 1.5f);
    rays.push_back({from, i % 2 ? 3e38f : 2.5f, glm::normalize(to - from)});
  }
  Renderer flat(scene, options("flat")), two(scene, options("two-level"));
  for (DeviceRay& ray : rays) ray.origin = glm::vec3(flat.state().placement.to_device(ray.origin));
  ASSERT_EQ(flat.state().placement.scale, 1);
  ASSERT_EQ(flat.state().instance_count, 0u);
  ASSERT_GT(two.state().instance_count, 55u);
  EXPECT_LT(two.state().primitives.bytes(), flat.state().primitives.bytes() / 4);
  RayCaster a(flat.state(), rays), b(two.state(), rays);
  a.cast(false);
  b.cast(false);
  const auto one = a.hits(), other = b.hits();
  int different = 0, met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    met += one[i].primitive != layout::kNoPrimitive;
    if (one[i].primitive != other[i].primitive) {
      ++different;
    } else if (one[i].primitive != layout::kNoPrimitive) {
      EXPECT_NEAR(one[i].t, other[i].t, 2e-4 * (1 + one[i].t));
    }
  }
  EXPECT_GT(met, 2000);
  EXPECT_LE(different, 40) << "more than rays through edges";
  a.cast(true);
  b.cast(true);
  const auto any_one = a.hits(), any_other = b.hits();
  different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    different += any_one[i].primitive != any_other[i].primitive;
    EXPECT_EQ(any_one[i].primitive == layout::kNoPrimitive, one[i].primitive == layout::kNoPrimitive) << i;
  }
  EXPECT_LE(different, 20);
}

TEST(TwoLevels, FetchVariantsGiveTheSameBits) {
  const Scene scene = instanced_scene(30, 4);
  Renderer texel(scene, options("two-level", "texel")), storage(scene, options("two-level", "storage"));
  EXPECT_EQ(texel.render(job(1)).image.pixels, storage.render(job(1)).image.pixels);
}

// A deep stack: boxes within boxes on both levels, so that entries wait in the array while an instance is
// walked.
TEST(TwoLevels, AnyDepthOfStack) {
  Scene scene = testing::random_soup(1000, 5, 24, 24);
  scene.objects.push_back({"soup", scene.shapes});
  for (int i = 0; i < 200; ++i) {
    const double at = 4e-3 * i;
    scene.instances.push_back(
        {0, glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(at, -at, at)), glm::dvec3(0.2 + at))});
  }
  scene.shapes.clear();
  Renderer flat(scene, options("flat")), two(scene, options("two-level"));
  const Comparison difference = compare(two.render(job(0.05)).image, flat.render(job(0.05)).image);
  EXPECT_LE(difference.beyond, 0.01);
  EXPECT_LE(std::abs(difference.mean_difference), 1e-3);
}

TEST(TwoLevels, IdsDoNotDependOnTheLevels) {
  const Scene scene = instanced_scene(10, 6);
  const Geometry flat = build_geometry(scene),
                 two = build_geometry(scene, {.two_level = true, .keep_instances = true});
  EXPECT_EQ(flat.triangle_count, two.triangle_count);
  EXPECT_EQ(flat.quadric_count, two.quadric_count);
  EXPECT_EQ(flat.triangle_count, scene.instanced_triangles());
  EXPECT_EQ(flat.instance_count(), 0u);
  EXPECT_EQ(two.instance_count(),
            10u);  // nine and the world's own: the flat one and the spheres are written out there
}

}  // namespace
}  // namespace capcon
