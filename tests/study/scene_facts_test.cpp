#include "study/scene_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace capcon {
namespace {

/// A unit square in z = 0, instanced once at x = 3, and a far light.
Scene small_scene() {
  Scene scene;
  scene.film.width = 640;
  scene.film.height = 400;
  scene.meshes.push_back({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}, {}});
  Shape square;
  scene.shapes.push_back(square);
  scene.objects.push_back({"o", {square}});
  scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(3, 0, 0))});
  Shape light;
  light.kind = ShapeKind::sphere;
  light.area_light = 0;
  light.to_world = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 1000));
  scene.shapes.push_back(light);
  return scene;
}

TEST(SceneFacts, DiagonalSeesInstancesAndNoLights) {
  Scene scene = small_scene();
  EXPECT_NEAR(diagonal(scene), std::sqrt(17.0), 1e-12);
  EXPECT_NEAR(default_radius(scene), 0.21, 1e-12);
  scene.shapes[1].area_light = -1;
  scene.shapes[1].radius = 2;
  EXPECT_NEAR(diagonal(scene), std::sqrt(6.0 * 6 + 4 * 4 + 1002.0 * 1002), 1e-9);
  EXPECT_TRUE(std::isinf(default_radius(Scene{})));
}

TEST(SceneFacts, FingerprintFollowsGeometryAndCamera) {
  const Scene scene = small_scene();
  EXPECT_EQ(fingerprint(scene), fingerprint(small_scene()));
  const auto differs = [&](auto change) {
    Scene other = scene;
    change(other);
    return fingerprint(other) != fingerprint(scene);
  };
  EXPECT_TRUE(differs([](Scene& s) { s.meshes[0].positions[2].x = 1.0001f; }));
  EXPECT_TRUE(differs([](Scene& s) { std::swap(s.meshes[0].triangles[0], s.meshes[0].triangles[1]); }));
  EXPECT_TRUE(differs([](Scene& s) { s.instances[0].to_world[3][0] = 4; }));
  EXPECT_TRUE(differs([](Scene& s) { s.camera.fov_degrees = 50; }));
  EXPECT_TRUE(differs([](Scene& s) { s.shapes[1].radius = 3; }));
  EXPECT_FALSE(differs([](Scene& s) { s.film.width = 10; }));
}

TEST(SceneFacts, FilmKeepsItsShape) {
  Scene scene = small_scene();
  set_film(scene, 0, 0, 10240);
  EXPECT_EQ(scene.film.width, 128);
  EXPECT_EQ(scene.film.height, 80);
  set_film(scene, 320, 0, 10240);
  EXPECT_EQ(scene.film.height, 200);
  set_film(scene, 0, 100, 10240);
  EXPECT_EQ(scene.film.width, 160);
  set_film(scene, 7, 9, 10240);
  EXPECT_EQ(scene.film.width * 100 + scene.film.height, 709);
}

TEST(SceneFacts, PointsFingerprintIsSteady) {
  EXPECT_EQ(points_fingerprint(), points_fingerprint());
}

}  // namespace
}  // namespace capcon
