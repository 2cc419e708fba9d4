// Direct lighting where the integral is known, by every strategy.
#include <gtest/gtest.h>

#include <array>

#include "reference/lighting.h"

namespace capcon {
namespace {

using std::numbers::pi;
using test::direct_job;
using test::kFloor;
using test::lamp;
using test::look_at_origin;
using test::matte;

constexpr double kAlbedo = 0.8;

/// What the floor shows of an irradiance: light samples of a smooth light to 1e-6; BSDF samples, which see
/// the light's outline, and both together within their own error. `small`: rays hardly ever meet the light.
void expect_irradiance(const std::string& light, double irradiance, bool small = false) {
  const double expected = kAlbedo / pi * irradiance;
  const Scene scene = look_at_origin(matte(kAlbedo) + kFloor + light);
  EXPECT_NEAR(test::radiance(scene, direct_job(1 << 16, Strategy::lights)).x, expected, 1e-6 * expected)
      << light;
  const Scene many = look_at_origin(matte(kAlbedo) + kFloor + light, 8);
  const Reference reference(many);
  for (const Strategy s : {Strategy::bsdf, Strategy::power, Strategy::balance}) {
    if (small && s == Strategy::bsdf) continue;
    const test::Estimate e = test::estimate(reference.render(direct_job(2048, s)).image);
    EXPECT_LT(std::abs(e.mean - expected), 4 * e.error + 1e-6 * expected) << light;
    EXPECT_LT(e.error, 0.005 * expected) << light;
  }
}

TEST(DirectClosedForms, Disk) {
  // Parallel and coaxial: pi L r^2 / (r^2 + d^2). A ring is the difference of two.
  expect_irradiance(lamp("ReverseOrientation Translate 0 0 2 Shape \"disk\" \"float radius\" 1.5"),
                    pi * 2.25 / (2.25 + 4));
  expect_irradiance(
      lamp("ReverseOrientation Translate 0 0 2 Shape \"disk\" \"float radius\" 1.5 \"float innerradius\" 1"),
      pi * (2.25 / (2.25 + 4) - 1 / 5.0));
}

/// Lambert's formula for a polygon above the plane z = 0, counter-clockwise from below, of radiance 1.
double polygon_irradiance(const std::vector<glm::dvec3>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::normalize(corners[i]), b = glm::normalize(corners[(i + 1) % corners.size()]);
    sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).z;
  }
  return sum / 2;
}

TEST(DirectClosedForms, RectangleAndTriangles) {
  // Off the axis and inclined; as a mesh with one more triangle it is no rectangle to the light's reader.
  const std::vector<glm::dvec3> corners = {{1, -1, 1}, {2, -1, 1.5}, {2, 1, 1.5}, {1, 1, 1}};
  const double irradiance = polygon_irradiance(corners);
  ASSERT_GT(irradiance, 0);
  const std::string points =
      "Shape \"trianglemesh\" \"point3 P\" [1 -1 1 2 -1 1.5 2 1 1.5 1 1 1 1.5 0 1.25] \"integer indices\" ";
  const std::string sides = "\"bool twosided\" true ";
  expect_irradiance(lamp(points + "[0 1 2 0 2 3]", sides), irradiance);
  expect_irradiance(lamp(points + "[0 1 4 1 2 4 2 3 4 3 0 4]", sides), irradiance);
}

TEST(DirectClosedForms, Sphere) {
  // pi L (r/d)^2 cos as long as all of it is above the plane.
  expect_irradiance(lamp("Translate 1 1 1.5 Shape \"sphere\" \"float radius\" .8"),
                    pi * 0.64 / 4.25 * 1.5 / std::sqrt(4.25));
  expect_irradiance(lamp("Translate 10 0 50 Shape \"sphere\" \"float radius\" .1"),
                    pi * 0.01 / 2600 * 50 / std::sqrt(2600), true);
}

TEST(DirectClosedForms, InsideALitSphereItIsWhiteEverywhere) {
  const std::string around = lamp("ReverseOrientation Translate 0 .1 .3 Shape \"sphere\" \"float radius\" 3");
  const std::string table = "Shape \"disk\" \"float radius\" .2 ";
  const Scene scene = look_at_origin(matte(kAlbedo) + table + around);
  for (const Strategy s : {Strategy::lights, Strategy::bsdf, Strategy::power}) {
    const double tolerance =
        s == Strategy::bsdf ? 1e-6 : 1e-3;  // the density of points on the sphere is not the cosine's
    EXPECT_NEAR(test::radiance(scene, direct_job(1 << 14, s)).x, kAlbedo, tolerance);
  }
  // The sphere's own wall is lit by the rest of it, and emits itself.
  const Scene wall = look_at_origin(
      matte(kAlbedo) + lamp("ReverseOrientation Translate 0 0 2 Shape \"sphere\" \"float radius\" 2"));
  for (const Strategy s : {Strategy::lights, Strategy::bsdf, Strategy::power})
    EXPECT_NEAR(test::radiance(wall, direct_job(1 << 14, s)).x, 1 + kAlbedo, 2e-3);
}

TEST(DirectClosedForms, AWhiteFurnaceIsWhite) {
  const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
  for (const double albedo : {1.0, 0.5}) {
    const Scene scene = look_at_origin(matte(albedo) + kFloor + sky);
    for (const Strategy s : {Strategy::lights, Strategy::bsdf, Strategy::power, Strategy::balance})
      EXPECT_NEAR(test::radiance(scene, direct_job(16, s)).x, albedo, 1e-7);  // every sample says so
  }
}

TEST(DirectClosedForms, PointAndDistantLights) {
  const Scene point = look_at_origin(matte(kAlbedo) + kFloor +
                                     "LightSource \"point\" \"rgb I\" [7 5 3] \"point3 from\" [2 1 2]");
  const Scene distant = look_at_origin(
      matte(kAlbedo) + kFloor +
      "LightSource \"distant\" \"rgb L\" [7 5 3] \"point3 from\" [2 1 2] \"point3 to\" [0 0 0]");
  for (const Strategy s : {Strategy::lights, Strategy::power, Strategy::balance}) {
    const glm::dvec3 p = test::radiance(point, direct_job(1, s)),
                     d = test::radiance(distant, direct_job(1, s));
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(p[c], kAlbedo / pi * (7 - 2 * c) / 9 * 2 / 3, 1e-6);
      EXPECT_NEAR(d[c], kAlbedo / pi * (7 - 2 * c) * 2 / 3, 1e-6);
    }
  }
  EXPECT_EQ(test::radiance(point, direct_job(4, Strategy::bsdf)), glm::dvec3(0));
  EXPECT_EQ(test::radiance(distant, direct_job(4, Strategy::bsdf)), glm::dvec3(0));
}

TEST(DirectClosedForms, TheErrorFallsAtTheRateOfTheNet) {
  // Light samples of a disk: the error of a scrambled net over a smooth function falls faster than 1/N; plain
  // Monte Carlo's as 1/sqrt(N).
  const Scene scene =
      look_at_origin(matte(kAlbedo) + kFloor +
                         lamp("ReverseOrientation Translate 1 0 2 Shape \"disk\" \"float radius\" 1.5"),
                     8);
  const Reference reference(scene);
  const auto error = [&](const char* sampler, std::uint32_t samples) {
    DirectLightingJob job = direct_job(samples, Strategy::lights);
    job.sampler = sampler;
    return test::estimate(reference.render(job).image).error;
  };
  EXPECT_GT(error("sobol-owen", 16) / error("sobol-owen", 1024), 64);
  EXPECT_NEAR(error("random", 16) / error("random", 1024), 8, 3);
}

}  // namespace
}  // namespace capcon
