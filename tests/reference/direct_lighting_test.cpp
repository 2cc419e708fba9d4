// Direct lighting: what is easily got wrong at the edges.
#include <gtest/gtest.h>

#include <cstdlib>

#include "reference/lighting.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

using std::numbers::pi;
using test::direct_job;
using test::kFloor;
using test::lamp;
using test::look_at_origin;
using test::matte;
using test::radiance;

const Strategy kAll[] = {Strategy::lights, Strategy::bsdf, Strategy::power, Strategy::balance};
const std::string kSky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
const std::string kDown = "ReverseOrientation Translate 0 0 2 Shape \"disk\" ";

/// Irradiance / pi from kDown's disk.
constexpr double kOfDisk = 1 / 5.0;

TEST(DirectLighting, WhatFacesAwayGivesNothing) {
  const std::string up = "Translate 0 0 2 Shape \"disk\" ",
                    under = "ReverseOrientation Translate 0 0 -1 Shape \"disk\" ";
  for (const Strategy s : kAll) {
    EXPECT_EQ(radiance(look_at_origin(matte(1) + kFloor + lamp(up)), direct_job(64, s)), glm::dvec3(0));
    EXPECT_EQ(radiance(look_at_origin(matte(1) + kFloor + lamp(under)), direct_job(64, s)), glm::dvec3(0));
    EXPECT_NEAR(
        radiance(look_at_origin(matte(1) + kFloor + lamp(up, "\"bool twosided\" true ")), direct_job(4096, s))
            .x,
        kOfDisk, 0.005);
    // A light with its back to the floor still hides what is behind it, and one that faces it is hidden by
    // nothing of its own.
    const std::string behind = lamp("ReverseOrientation Translate 0 0 9 Shape \"disk\" \"float radius\" 4");
    EXPECT_EQ(radiance(look_at_origin(matte(1) + kFloor + lamp(up + "\"float radius\" 3 ") + behind),
                       direct_job(64, s)),
              glm::dvec3(0));
    // A screen in between.
    const std::string screen = test::within(matte(0) + "Translate 0 0 1 Shape \"disk\" ");
    EXPECT_EQ(
        radiance(look_at_origin(matte(1) + kFloor + screen + lamp(kDown), 1, {9, 0, 0.5}), direct_job(64, s)),
        glm::dvec3(0));
  }
}

TEST(DirectLighting, ALightThatIsFlushWithAWallIsNotHidden) {
  // By light samples; which of two surfaces in one plane a ray meets is nobody's promise.
  const std::string ceiling = test::within(matte(0) + "Translate 0 0 2 Shape \"disk\" \"float radius\" 30 ");
  const Scene scene = look_at_origin(matte(1) + kFloor + ceiling + lamp(kDown));
  EXPECT_NEAR(radiance(scene, direct_job(4096, Strategy::lights)).x, kOfDisk, 1e-5);
  // Yet a shade just before it hides it: all but 2^-17 of the way is looked at.
  const std::string shade =
      test::within(matte(0) + "Translate 0 0 1.9999 Shape \"disk\" \"float radius\" 2 ");
  const Scene shaded = look_at_origin(matte(1) + kFloor + shade + lamp(kDown));
  EXPECT_EQ(radiance(shaded, direct_job(64, Strategy::lights)), glm::dvec3(0));
}

TEST(DirectLighting, LightsAreSeen) {
  Scene scene =
      test::parse_world(lamp("Shape \"sphere\" ") + "LightSource \"infinite\" \"rgb L\" [.25 .5 .75]\n");
  scene.film = {1, 1, ""};
  scene.camera = test::camera_at({0, 0, 5}, {0, 0, -1});
  for (const Strategy s : kAll) {
    DirectLightingJob job = direct_job(16, s);
    job.image_samples = 2;
    // The ball's own material, grey of 1/2, reflects the sky.
    EXPECT_NEAR(radiance(scene, job).x, 1 + 0.5 * 0.25, 1e-6);
  }
  scene.camera = test::camera_at({0, 0, 5}, {0, 0, 1});
  const RenderResult away = Reference(scene).render(direct_job(16));
  EXPECT_EQ(test::pixel(away.image, 0, 0), glm::dvec3(0.25, 0.5, 0.75));
  EXPECT_EQ(away.rays, 0u);
  // A disk from either side.
  Scene disk = test::parse_world(matte(0) + lamp("Shape \"disk\" "));
  disk.film = {1, 1, ""};
  for (const double z : {1.0, -1.0}) {
    disk.camera = test::camera_at({0.1, 0.2, 5 * z}, {0, 0, -z});
    EXPECT_EQ(radiance(disk, direct_job(1)).x, z > 0 ? 1 : 0);
  }
}

TEST(DirectLighting, EnvironmentMapsAreSeenWhereTheyShine) {
  Scene scene =
      test::parse_world("LightSource \"infinite\" \"string mapname\" \"map\"\n" + matte(1) + kFloor);
  Image map(32, 16, 3);
  for (float& v : map.pixels) v = 0;
  for (int c = 0; c < 3; ++c) map.at(8, 2, c) = float(c + 1);  // towards +y, at (2.5/16) 180 degrees from +z
  scene.images.push_back({"map", map});
  scene.lights[0].image = 0;
  scene.film = {1, 1, ""};
  const double theta = 2.5 / 16 * pi, phi = 8.5 / 32 * 2 * pi;
  const glm::dvec3 to(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  scene.camera = test::camera_at({0, 0, 1}, to);
  EXPECT_NEAR(radiance(scene, direct_job(1)).z, 3, 1e-5);
  scene.camera = test::camera_at({0, 0, 1}, {to.x, -to.y, to.z});
  EXPECT_EQ(radiance(scene, direct_job(1)).z, 0);
  // The floor: the bilinear tent integrates to cos times its solid angle, nearly.
  scene.camera = test::camera_at({0, 0, 1}, {0.1, 0.1, -1});
  const double solid_angle = (std::cos(2 * pi / 16) - std::cos(3 * pi / 16)) * 2 * pi / 32;
  for (const Strategy s : {Strategy::lights, Strategy::power})
    EXPECT_NEAR(radiance(scene, direct_job(4096, s)).x / (std::cos(theta) * solid_angle / pi), 1, 0.02);
}

TEST(DirectLighting, HiddenLightsShineUnseen) {
  const Scene scene = look_at_origin(matte(1) + kFloor + lamp(kDown + "\"float alpha\" 0 "));
  ASSERT_EQ(scene.hidden_shapes.size(), 1u);
  for (const Strategy s : {Strategy::lights, Strategy::power, Strategy::balance})
    EXPECT_NEAR(radiance(scene, direct_job(1 << 14, s)).x, kOfDisk, 1e-6);
  EXPECT_EQ(radiance(scene, direct_job(64, Strategy::bsdf)), glm::dvec3(0));
  Scene up = scene;
  up.camera = test::camera_at({0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(radiance(up, direct_job(1)), glm::dvec3(0));
}

TEST(DirectLighting, BlackAndUnlitScenesAreBlack) {
  for (const Strategy s : kAll) {
    const Scene black = look_at_origin(matte(0) + kFloor + lamp(kDown) + kSky);
    const RenderResult result = Reference(black).render(direct_job(16, s));
    EXPECT_EQ(test::pixel(result.image, 0, 0), glm::dvec3(0));
    EXPECT_EQ(result.rays, 0u);
    EXPECT_EQ(radiance(look_at_origin(matte(1) + kFloor), direct_job(16, s)), glm::dvec3(0));
    EXPECT_EQ(radiance(look_at_origin(""), direct_job(16, s)), glm::dvec3(0));
  }
}

/// A floor whose normals are (0.6, 0, 0.8).
const std::string kTilted =
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 0 50 -50 0 50 50 0 -50 50 0] \"integer indices\" [0 1 2 0 "
    "2 3] "
    "\"normal N\" [.6 0 .8  .6 0 .8  .6 0 .8  .6 0 .8]\n";

std::string sun(const std::string& from) {
  return "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 to\" [0 0 0] \"point3 from\" [" + from + "]\n";
}

TEST(DirectLighting, ShadingNormalsTurnTheSurface) {
  const DirectLightingJob job = direct_job(1, Strategy::lights);
  const auto value = [&](const std::string& text, const glm::dvec3& eye = {0.1, 0, 1}) {
    return radiance(look_at_origin(matte(1) + text, 1, eye), job).x * pi;
  };
  EXPECT_NEAR(value(kTilted + sun("0 0 1")), 0.8, 1e-6);
  EXPECT_NEAR(value(kTilted + sun(".6 0 .8")), 1, 1e-6);
  EXPECT_EQ(value(kTilted + sun("-.9 0 .1")), 0);  // above the surface, not above its normal
  EXPECT_EQ(value(kTilted + sun(".9 0 -.1")), 0);  // above the normal alone
  // Seen from below it is turned: lit from there alone.
  EXPECT_NEAR(value(kTilted + sun("-.6 0 -.8"), {0.1, 0, -1}), 1, 1e-6);
  EXPECT_EQ(value(kTilted + sun(".6 0 .8"), {0.1, 0, -1}), 0);
  // A normal that faces away from the viewer gives way to the geometric one.
  EXPECT_NEAR(value(kTilted + sun("0 0 1"), {-1, 0, 0.1}), 1, 1e-6);
  // Normals go by the inverse transpose: x stretched by 2 leaves (0.3, 0, 0.8).
  EXPECT_NEAR(value("Scale 2 1 1 " + kTilted + "Identity " + sun("0 0 1")), 0.8 / std::hypot(0.3, 0.8), 1e-6);
  EXPECT_NEAR(value("ObjectBegin \"o\" " + kTilted + "ObjectEnd Scale 2 1 1 ObjectInstance \"o\" Identity " +
                    sun("0 0 1")),
              0.8 / std::hypot(0.3, 0.8), 1e-6);
}

TEST(DirectLighting, NormalsAreInterpolatedAsUnitVectors) {
  // At the middle of the edge between normals z and 100 x: (1, 0, 1) / sqrt(2).
  const std::string sheet =
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"integer indices\" [0 1 2 0 2 3] "
      "\"normal N\" [0 0 1  0 0 1  100 0 0  0 0 1]\n";
  const Scene scene = look_at_origin(matte(1) + sheet + sun("0 0 1"), 1, {0.5, 0, 1});
  EXPECT_NEAR(radiance(scene, direct_job(1, Strategy::lights)).x * pi, std::sqrt(0.5), 1e-6);
}

TEST(DirectLighting, TexturesAreLookedUpAtTheUv) {
  const std::string material =
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.png\"\nMaterial \"diffuse\" \"texture "
      "reflectance\" \"t\"\n";
  // uv = (3/4, 3/4) at the origin.
  const std::string own =
      "Shape \"trianglemesh\" \"point3 P\" [-3 -3 0 1 -3 0 1 1 0 -3 1 0] \"integer indices\" [0 1 2 0 2 3] "
      "\"point2 uv\" [0 0 1 0 1 1 0 1]\n";
  // Without uvs: the corners (0, 0), (1, 0), (1, 1) of each triangle; the origin is at (1/2, 1/4) of the
  // first.
  const std::string none =
      "Shape \"trianglemesh\" \"point3 P\" [-2 -1 0 2 -1 0 2 3 0] \"integer indices\" [0 1 2]\n";
  const auto value = [&](const std::string& shape) {
    Scene scene = look_at_origin(material + shape + sun("0 0 1"));
    Image image(4, 4, 3);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        image.at(x, y, 0) = float(x) / 8, image.at(x, y, 1) = float(3 - y) / 8, image.at(x, y, 2) = 0.5f;
      }
    }
    scene.images.assign(1, {"t.png", image});
    for (Entity& texture : scene.textures) texture.image = 0;
    return radiance(scene, direct_job(1, Strategy::lights)) * pi;
  };
  // A texel's centre (x + 1/2) / 4 has x / 8: u is (4 u - 1/2) / 8.
  const glm::dvec3 a = value(own), b = value(none);
  EXPECT_LT(glm::distance(a, glm::dvec3(2.5 / 8, 2.5 / 8, 0.5)), 1e-5) << a.x << " " << a.y << " " << a.z;
  EXPECT_LT(glm::distance(b, glm::dvec3(1.5 / 8, 0.5 / 8, 0.5)), 1e-5) << b.x << " " << b.y << " " << b.z;
}

TEST(DirectLighting, ObjectsKeepTheirMaterialsAndAreNoLights) {
  const std::string lit = "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] ";
  const Scene scene =
      look_at_origin("ObjectBegin \"o\" " + matte(0.25) + lit + kFloor + "ObjectEnd " + matte(1) +
                     test::within("Translate 0 0 30 " + kFloor) + "ObjectInstance \"o\" " + sun("0 0 1") +
                     "LightSource \"point\" \"rgb I\" [4 4 4] \"point3 from\" [0 0 2]\n");
  EXPECT_NEAR(radiance(scene, direct_job(1, Strategy::lights)).x * pi, 0.25, 1e-6);  // the roof hides the sun
}

TEST(DirectLighting, SameBitsForAnyNumberOfThreadsAndWhateverTheJob) {
  Scene scene = look_at_origin(matte(1) + kFloor + lamp(kDown) + kSky, 8);
  scene.camera.fov_degrees = 60;
  const Reference reference(scene);
  DirectLightingJob job = direct_job(4);
  job.image_samples = 4;
  job.position = PixelPosition::jittered;
  setenv("CAPCON_THREADS", "1", 1);
  const RenderResult one = reference.render(job);
  setenv("CAPCON_THREADS", "4", 1);
  const RenderResult four = reference.render(Job(job));
  unsetenv("CAPCON_THREADS");
  EXPECT_EQ(one.image.channels, 3);
  EXPECT_EQ(one.image.pixels, four.image.pixels);
  EXPECT_EQ(one.rays, four.rays);
  EXPECT_EQ(reference.render(Job(AmbientOcclusionJob())).image.channels, 1);
}

TEST(DirectLighting, RaysAreCounted) {
  // Under a sky each point is worth a ray.
  const Scene scene = look_at_origin(matte(1) + kFloor + kSky + kSky, 2);
  for (const auto& [strategy, rays] :
       {std::pair{Strategy::lights, 8}, {Strategy::bsdf, 4}, {Strategy::power, 12}})
    EXPECT_EQ(Reference(scene).render(direct_job(4, strategy)).rays, std::uint64_t(4 * rays));
}

}  // namespace
}  // namespace capcon
