#include "shading/light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/scene_text.h"
#include "shading/scene_bounds.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

using test::error_of;
using test::parse_world;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = 3.14159265358979323846;

Lights lights_of(const std::string& text) {
  return read_lights(parse_world(text, {true, false, false}));
}

/// The only light of a text that gives rise to no warning.
Light light_of(const std::string& text) {
  const Lights lights = lights_of(text);
  EXPECT_THAT(lights.warnings, ElementsAre());
  EXPECT_EQ(lights.values.size(), 1u);
  return lights.values.at(0);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

const std::string kArea = "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] ";

TEST(Light, DiskAsInTheAnchors) {
  const Light light = light_of(
      "AreaLightSource \"area\" \"color L\" [15 15 15] \"integer nsamples\" [16] Translate 0.5 6.5 -1 Rotate "
      "90 1 0 0 Shape "
      "\"disk\" \"float radius\" [1.5]");
  EXPECT_EQ(light.kind, LightKind::disk);
  expect_near(light.position, {0.5, 6.5, -1});
  expect_near(light.normal, {0, -1, 0});
  EXPECT_NEAR(glm::length(light.axis_u), 1.5, 1e-12);
  EXPECT_NEAR(light.area, kPi * 2.25, 1e-9);
  expect_near(light.power, glm::dvec3(kPi * kPi * 2.25 * 15), 1e-9);
  EXPECT_FALSE(light.two_sided);
}

TEST(Light, DisksOfAnyTransform) {
  expect_near(light_of(kArea + "Scale 1 1 -1 Shape \"disk\" \"float height\" 2").normal, {0, 0, -1});
  expect_near(light_of(kArea + "Scale -1 1 1 Shape \"disk\"").normal, {0, 0, 1});
  expect_near(light_of(kArea + "ReverseOrientation Shape \"disk\"").normal, {0, 0, -1});
  const Light ring =
      light_of(kArea + "Scale 2 3 5 Shape \"disk\" \"float innerradius\" .5 \"float height\" 2");
  EXPECT_NEAR(ring.area, kPi * 6 * 0.75, 1e-9);
  EXPECT_EQ(ring.inner, 0.5);
  expect_near(ring.position, {0, 0, 10});
  // A shear keeps the plane: its normal stays, the point above the middle moves.
  const Light sheared =
      light_of(kArea + "ConcatTransform [1 0 0 0 0 1 0 0 1 0 1 0 0 0 0 1] Shape \"disk\" \"float height\" 1");
  expect_near(sheared.normal, {0, 0, 1});
  expect_near(sheared.position, {1, 0, 1});
}

TEST(Light, Spheres) {
  const Light light = light_of(kArea + "Translate 1 2 3 Scale -2 2 2 Shape \"sphere\" \"float radius\" 1.5");
  EXPECT_EQ(light.kind, LightKind::sphere);
  expect_near(light.position, {1, 2, 3});
  EXPECT_NEAR(light.radius, 3, 1e-12);
  EXPECT_NEAR(light.area, 36 * kPi, 1e-9);
  EXPECT_FALSE(light.inward);
  EXPECT_TRUE(light_of(kArea + "ReverseOrientation Shape \"sphere\"").inward);
}

TEST(Light, EllipsoidsBecomeTriangles) {
  const Lights lights = lights_of(kArea + "Scale 1 1 2 Shape \"sphere\"");
  ASSERT_EQ(lights.values.size(), 1u);
  const Light& light = lights.values[0];
  EXPECT_EQ(light.kind, LightKind::triangles);
  // Prolate spheroid, a = 1, c = 2: 2 pi (1 + c/e asin e), e^2 = 3/4.
  const double e = std::sqrt(0.75);
  EXPECT_NEAR(light.area, 2 * kPi * (1 + 2 / e * std::asin(e)), 1e-3);
  EXPECT_EQ(lights.areas.back(), light.area);
  EXPECT_THAT(lights.warnings, ElementsAre(HasSubstr("ellipsoid")));
  for (std::size_t i = 0; i < lights.triangles.size(); i += 997) {
    const LightTriangle& t = lights.triangles[i];
    EXPECT_GT(glm::dot(glm::cross(t.b - t.a, t.c - t.a), t.a), 0);  // outwards
  }
}

const std::string kThree =
    "Shape \"trianglemesh\" \"point3 P\" [0 0 0 2 0 0 0 2 0 0 0 7 1 0 7 0 0 8] \"integer indices\" [0 1 2 3 "
    "4 5] ";

TEST(Light, TrianglesWithTheirAreasAndSides) {
  const Lights lights = lights_of(kArea + kThree);
  ASSERT_EQ(lights.values.size(), 1u);
  EXPECT_EQ(lights.values[0].kind, LightKind::triangles);
  EXPECT_THAT(lights.areas, ElementsAre(2, 2.5));
  EXPECT_EQ(lights.values[0].area, 2.5);
  expect_near(lights.values[0].power, 2.5 * kPi * glm::dvec3(1, 2, 3));
  const auto normal = [&](const std::string& text) {
    const Lights all = lights_of(text);
    const LightTriangle& t = all.triangles.at(0);
    return glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
  };
  expect_near(normal(kArea + kThree), {0, 0, 1});
  expect_near(normal(kArea + "ReverseOrientation " + kThree), {0, 0, -1});
  expect_near(normal(kArea + "Scale -1 1 1 " + kThree), {0, 0, 1});
  expect_near(normal(kArea + "Scale 1 1 -1 " + kThree), {0, 0, -1});
  const std::string down = " \"normal N\" [0 0 -1 0 0 -1 0 0 -1 0 0 -1 0 0 -1 0 0 -1] ";
  expect_near(normal(kArea + kThree + down), {0, 0, -1});
  expect_near(normal(kArea + "ReverseOrientation " + kThree + down), {0, 0, 1});
  expect_near(normal(kArea + "Scale -1 1 1 " + kThree + down), {0, 0, -1});
}

TEST(Light, TwoTrianglesMakeARectangle) {
  for (const char* indices : {"0 1 2 0 2 3", "0 1 3 1 2 3", "2 0 1 3 0 2"}) {
    const Lights lights = lights_of(
        kArea +
        "Scale 2 1 1 Shape \"trianglemesh\" \"point3 P\" [0 0 1 1 0 1 1 1 1 0 1 1] \"integer indices\" [" +
        indices + "]");
    ASSERT_EQ(lights.values.size(), 1u);
    const Light& light = lights.values[0];
    EXPECT_EQ(light.kind, LightKind::rectangle) << indices;
    EXPECT_NEAR(light.area, 2, 1e-12);
    expect_near(light.normal, {0, 0, 1});
    expect_near(light.position + 0.5 * light.axis_u + 0.5 * light.axis_v, {1, 0.5, 1});
    EXPECT_TRUE(lights.triangles.empty());
  }
  const auto kind = [](const std::string& indices) {
    return lights_of(kArea +
                     "Shape \"trianglemesh\" \"point3 P\" [0 0 1 1 0 1 1 1 1 0 1 1 0 2 1 0 1 5] \"integer "
                     "indices\" [" +
                     indices + "]")
        .values.at(0)
        .kind;
  };
  EXPECT_EQ(kind("0 1 2 0 3 2"), LightKind::triangles);  // they face opposite ways
  EXPECT_EQ(kind("0 1 2 0 2 4"), LightKind::triangles);  // no parallelogram
  EXPECT_EQ(kind("0 1 2 0 2 5"), LightKind::triangles);  // not in a plane
  EXPECT_EQ(kind("0 1 2 0 1 2"), LightKind::triangles);  // twice the same
}

TEST(Light, ScalesPowersAndSides) {
  expect_near(
      light_of("AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"float scale\" 2 Shape \"disk\"").radiance,
      {2, 4, 6});
  expect_near(light_of("AreaLightSource \"area\" \"color L\" [1 2 3] \"color scale\" [1 0 2] Shape \"disk\"")
                  .radiance,
              {1, 0, 6});
  const Light power =
      light_of("AreaLightSource \"diffuse\" \"float power\" 10 \"bool twosided\" true Shape \"disk\"");
  EXPECT_TRUE(power.two_sided);
  expect_near(power.power, glm::dvec3(10));
  expect_near(power.radiance, glm::dvec3(10 / (2 * kPi * kPi)));
  const Light warm = light_of("AreaLightSource \"diffuse\" \"blackbody L\" 3000 Shape \"disk\"");
  EXPECT_NEAR(luminance(warm.radiance), 1, 1e-6);
  EXPECT_GT(warm.radiance.r, 2 * warm.radiance.b);
  expect_near(light_of("AreaLightSource \"diffuse\" \"blackbody L\" [3000 4] Shape \"disk\"").radiance,
              4.0 * rgb_of_blackbody(3000));
}

TEST(Light, PointsAndDistantOnes) {
  const Light point = light_of(
      "Translate 1 2 3 LightSource \"point\" \"rgb I\" [1 2 3] \"point3 from\" [0 0 1] Shape \"sphere\"");
  EXPECT_EQ(point.kind, LightKind::point);
  expect_near(point.position, {1, 2, 4});
  expect_near(point.power, 4 * kPi * glm::dvec3(1, 2, 3));
  expect_near(light_of("LightSource \"point\" \"float power\" 8 Shape \"sphere\"").power, glm::dvec3(8));
  const Light sun = light_of(
      "Rotate 90 1 0 0 LightSource \"distant\" \"rgb L\" [3 2 1] \"point3 from\" [0 0 5] \"point3 to\" [0 0 "
      "0] Shape \"sphere\"");
  EXPECT_EQ(sun.kind, LightKind::distant);
  expect_near(sun.normal, {0, 1, 0});  // from above, z, which the rotation sends to -y
  expect_near(sun.power,
              kPi * 3 * glm::dvec3(3, 2, 1));  // the sphere about a box of half extent 1: radius sqrt 3
  expect_near(light_of("LightSource \"distant\" \"float illuminance\" 5 Shape \"sphere\"").radiance,
              glm::dvec3(5));
}

TEST(Light, ConstantEnvironment) {
  const Light sky = light_of("LightSource \"infinite\" \"rgb L\" [.5 1 2] Shape \"sphere\"");
  EXPECT_EQ(sky.kind, LightKind::environment);
  EXPECT_EQ(sky.environment, -1);
  expect_near(sky.power, 4 * kPi * kPi * 3 * glm::dvec3(0.5, 1, 2));
  expect_near(light_of("LightSource \"infinite\" \"float illuminance\" 7 Shape \"sphere\"").radiance,
              glm::dvec3(7 / kPi));
}

/// A scene with an environment image whose texels are `value`(column, row).
template <typename Value>
Scene with_map(const std::string& text, int width, int height, const Value& value) {
  Scene scene = parse_world(text + " Shape \"sphere\"");
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = value(x, y);
    }
  }
  scene.images.push_back({"map.exr", image});
  scene.lights.at(0).image = 0;
  return scene;
}

TEST(Light, MapsAreTurnedAsPbrtTurnsThem) {
  // The anchors' environment: u = atan2(-wz, wx)/2pi, v = acos(wy)/pi, row 0 at the top.
  const auto value = [](int x, int y) { return static_cast<float>(1 + x + 100 * y); };
  const Scene scene =
      with_map("Rotate -90 1 0 0 LightSource \"infinite\" \"color L\" [5 5 5] \"string mapname\" \"map.exr\"",
               16, 8, value);
  const Lights lights = read_lights(scene);
  EXPECT_THAT(lights.warnings, ElementsAre());
  const Light& light = lights.values.at(0);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double phi = 2 * kPi * (x + 0.5) / 16, theta = kPi * (y + 0.5) / 8;
      const glm::dvec3 w(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
      EXPECT_NEAR(environment_radiance(scene, lights, light, w).g, 5 * value(x, y), 1e-6);
    }
  }
  expect_near(light.power, lights.environments[0].table.integral * 5.0 * kPi * 3.0, 1e-6);
}

TEST(Light, MapsOfTheVersions) {
  const auto one = [](int, int) { return 1.f; };
  const auto map = [&](const std::string& parameter, int width, int height, std::size_t warnings) {
    const Lights lights = read_lights(with_map("LightSource \"infinite\" " + parameter, width, height, one));
    EXPECT_EQ(lights.warnings.size(), warnings);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(lights.values.at(0).power[c], 4 * kPi * kPi * 3, 1e-6);
    return lights.environments.at(0).table.map;
  };
  EXPECT_EQ(map("\"string filename\" \"map.exr\"", 8, 8, 0), SphereMap::octahedral);
  EXPECT_EQ(map("\"string filename\" \"map.exr\"", 8, 4, 1), SphereMap::lat_long);
  EXPECT_EQ(map("\"string mapname\" \"map.exr\"", 8, 8, 0), SphereMap::lat_long);
}

TEST(Light, MapsMirrorWithTheirTransformAndKeepOnlyRotations) {
  const auto value = [](int x, int) { return static_cast<float>(x); };
  const Scene mirrored =
      with_map("Scale -2 2 2 LightSource \"infinite\" \"string mapname\" \"map.exr\"", 8, 4, value);
  const Lights lights = read_lights(mirrored);
  EXPECT_THAT(lights.warnings, ElementsAre());
  const glm::dvec3 direction = direction_of_square(SphereMap::lat_long, {1.5 / 8, 0.5});
  EXPECT_NEAR(
      environment_radiance(mirrored, lights, lights.values[0], {-direction.x, direction.y, direction.z}).g, 1,
      1e-9);
  EXPECT_THAT(read_lights(with_map("Scale 1 2 1 LightSource \"infinite\" \"string mapname\" \"map.exr\"", 8,
                                   4, value))
                  .warnings,
              ElementsAre(HasSubstr("only the rotation is kept")));
}

TEST(Light, IlluminanceByTheUpperHalf) {
  // A bright upper half: E = pi L of the cosine-weighted upper half.
  const Scene scene =
      with_map("LightSource \"infinite\" \"string mapname\" \"map.exr\" \"float illuminance\" 6", 64, 32,
               [](int, int y) { return y < 16 ? 2.f : 0.f; });
  expect_near(read_lights(scene).values.at(0).radiance, glm::dvec3(6 / (2 * kPi)), 2e-3);
}

TEST(Light, WhatEmitsNothingIsLeftOut) {
  const Lights lights = lights_of(
      "LightSource \"point\" \"rgb I\" [0 0 0] AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [0 0 "
      "0] " +
      kThree + " AttributeEnd " + kArea + kThree);
  ASSERT_EQ(lights.values.size(), 1u);
  EXPECT_EQ(lights.values[0].first_triangle, 0u);
  EXPECT_EQ(lights.triangles.size(), 2u);
  EXPECT_EQ(lights.areas.size(), 2u);
  EXPECT_THAT(lights.of_shape, ElementsAre(-1, 0));
  EXPECT_EQ(lights.warnings.size(), 2u);
  const Lights black = read_lights(with_map("LightSource \"infinite\" \"string mapname\" \"map.exr\"", 4, 2,
                                            [](int, int) { return 0.f; }));
  EXPECT_TRUE(black.values.empty());
  EXPECT_TRUE(black.environments.empty());
}

TEST(Light, ApproximationsAndMistakesAreSaid) {
  const Lights lights = lights_of(
      "LightSource \"spot\" LightSource \"laser\" AreaLightSource \"odd\" Shape \"disk\"\nAreaLightSource "
      "\"diffuse\" \"string "
      "filename\" \"a.exr\" Shape \"disk\"");
  EXPECT_THAT(lights.warnings,
              testing::UnorderedElementsAre(
                  "s.pbrt:2:1: this spot light is a point light that shines in all directions",
                  "s.pbrt:2:20: lights of the kind \"laser\" are left out",
                  "s.pbrt:2:40: area lights of the kind \"odd\" are left out",
                  "s.pbrt:3:1: images on area lights are left out"));
  EXPECT_EQ(lights.values.size(), 2u);
  EXPECT_EQ(error_of([] { lights_of("LightSource \"distant\" \"point3 from\" [0 0 1]"); }),
            "s.pbrt:2:1: a distant light's \"from\" and \"to\" must differ");
  EXPECT_EQ(error_of([] { lights_of("LightSource \"point\" \"point3 from\" [0 0 1 0 0 2]"); }),
            "s.pbrt:2:21: \"from\" must be one point");
}

TEST(Light, HiddenShapesEmit) {
  const Lights lights = lights_of(kArea + "Shape \"disk\" \"float alpha\" 0");
  ASSERT_EQ(lights.values.size(), 1u);
  EXPECT_TRUE(lights.values[0].hidden);
  EXPECT_TRUE(lights.of_shape.empty());
}

TEST(Light, BoundsCoverInstances) {
  const Scene scene = parse_world(
      "ObjectBegin \"o\" Translate 1 0 0 Shape \"sphere\" ObjectEnd AttributeBegin Translate 9 0 0 "
      "ObjectInstance \"o\" "
      "AttributeEnd Shape \"disk\" \"float radius\" 2");
  const BoundingSphere bounds = scene_bounds(scene);
  expect_near(bounds.centre, {4.5, 0, 0});  // x from -2 to 11
  EXPECT_NEAR(bounds.radius, std::sqrt(6.5 * 6.5 + 4 + 1), 1e-9);
  EXPECT_EQ(scene_bounds(Scene{}).radius, 0);
}

}  // namespace
}  // namespace capcon
