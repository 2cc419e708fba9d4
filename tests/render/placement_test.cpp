#include "render/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "image/compare.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

TEST(Placement, LeavesUsualScenesWhereTheyAre) {
  const Placement p = place_scene({{1, 2, 0}, 3}, {4, 2, 1});
  EXPECT_EQ(p.origin, glm::dvec3(0));
  EXPECT_EQ(p.scale, 1);
  EXPECT_EQ(place_scene({}, {1e9, 0, 0}).origin, glm::dvec3(0)) << "an empty scene";
}

TEST(Placement, BringsFarScenesNearTheCamera) {
  const BoundingSphere bounds{{1e6, -2e6, 3e5}, 3};
  const glm::dvec3 inside = bounds.centre + glm::dvec3(1, -1.3, .7);
  const Placement p = place_scene(bounds, inside);
  EXPECT_LT(glm::length(p.to_device(inside)), 0.5);  // a grid of 1/2
  EXPECT_EQ(2.0 * p.origin, glm::round(2.0 * p.origin));
  EXPECT_EQ(p.to_world(p.to_device(inside)), inside);
  // From far away it is the scene's middle that is near.
  EXPECT_LT(glm::length(place_scene(bounds, {0, 0, 0}).to_device(bounds.centre)), 0.5);
}

TEST(Placement, ScalesByPowersOfTwo) {
  for (const double radius : {1e-9, 1e-3, 1e5, 1e12}) {
    const double scale = place_scene({{0, 0, 0}, radius}, {0, 0, 0}).scale;
    EXPECT_EQ(std::log2(scale), std::round(std::log2(scale)));
    EXPECT_GE(scale * radius, 1);
    EXPECT_LT(scale * radius, 2);
  }
}

TEST(Placement, KeepsIrradiance) {
  Lights lights;
  lights.values.resize(2);
  lights.values[0].kind = LightKind::point;
  lights.values[0].radiance = glm::dvec3(8);
  lights.values[1].kind = LightKind::sphere;
  lights.values[1].radiance = glm::dvec3(3);
  lights.values[1].radius = 2;
  lights.values[1].power = glm::dvec3(5);
  place_lights(lights, {{1, 0, 0}, 0.5});
  EXPECT_EQ(lights.values[0].radiance.x, 2);  // over a quarter of the square of distances
  EXPECT_EQ(lights.values[1].radiance.x, 3);
  EXPECT_EQ(lights.values[1].radius, 1);
  EXPECT_EQ(lights.values[1].power.x, 5 * 0.25);
}

// Rays that leave a large sphere from inside start off it by the rounding of its middle, not of where they
// start.
TEST(Placement, ALargeSphereFromInsideDoesNotHideItself) {
  Scene scene;
  scene.name = "inside";
  scene.film = {32, 24, ""};
  scene.camera = testing::camera_at({.4, .2, 3}, 60);
  Shape sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.radius = 100;
  sphere.to_world = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -96));
  scene.shapes.push_back(sphere);
  AmbientOcclusionJob job;
  job.radius = 0.3;
  Renderer renderer(scene, {.device = "lavapipe"});
  const Image image = renderer.render(job).image, truth = Reference(scene).render(job).image;
  EXPECT_EQ(compare(image, truth).beyond, 0);
  EXPECT_EQ(truth.pixels[0], 1);
}

}  // namespace
}  // namespace capcon
