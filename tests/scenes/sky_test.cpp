// The generated sky holds the light that its formula and this page of numbers promise.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "generator/sky.h"
#include "shading/spectrum.h"
#include "shading/sphere_map.h"

namespace capcon {
namespace {

constexpr double kPi = scenes::kPi;

/// Radiance integrated over all directions that a test admits.
template <class Admit>
glm::dvec3 integral(const Image& image, const Admit& admit) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y) {
    const double angle = texel_solid_angle(SphereMap::lat_long, image.width, image.height, y);
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 d =
          direction_of_square(SphereMap::lat_long, {(x + 0.5) / image.width, (y + 0.5) / image.height});
      if (admit(d)) sum += angle * sphere_texel(SphereMap::lat_long, image, x, y);
    }
  }
  return sum;
}

TEST(Sky, IsTheSameEveryTime) {
  EXPECT_TRUE(scenes::sky_map({}, 128).pixels == scenes::sky_map({}, 128).pixels);
}

TEST(Sky, HoldsTheSunThatItDescribes) {
  const scenes::Sky sky;
  scenes::Sky dark = sky;
  dark.sun_radiance = scenes::Vec3(0);
  const auto all = [](const glm::dvec3&) { return true; };
  const glm::dvec3 with = integral(scenes::sky_map(sky, 512), all),
                   without = integral(scenes::sky_map(dark, 512), all);
  // The edge is even about the radius, so the solid angle is the disk's up to a thousandth.
  const double disk = 2 * kPi * (1 - std::cos(sky.sun_radius * kPi / 180));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR((with - without)[c] / (disk * sky.sun_radiance[c]), 1, 0.01) << c;
  const double share = luminance(with - without) / luminance(with);
  EXPECT_NEAR(luminance(with), 6.11, 0.02);
  EXPECT_NEAR(share, 0.37, 0.01);  // docs/scenes.md
}

TEST(Sky, PutsTheSunWhereTheLightReaderLooksForIt) {
  const scenes::Sky sky;
  const Image image = scenes::sky_map(sky, 512);
  const glm::dvec3 sun = glm::normalize(sky.sun);
  const glm::dvec3 there = sphere_lookup(SphereMap::lat_long, image, sun);
  EXPECT_NEAR(there.x / (sky.sun_radiance.x + sky.background(sun).x), 1, 1e-3);
  const glm::dvec3 near =
      integral(image, [&](const glm::dvec3& d) { return glm::dot(d, sun) > std::cos(0.04); });
  const glm::dvec3 mirrored = integral(
      image, [&](const glm::dvec3& d) { return glm::dot(d * glm::dvec3(1, -1, 1), sun) > std::cos(0.04); });
  EXPECT_GT(near.x, 100 * mirrored.x);
}

TEST(Sky, IntegratesAsItsFormulaDoes) {
  scenes::Sky sky;
  sky.sun_radiance = scenes::Vec3(0);
  const Image image = scenes::sky_map(sky, 256);
  const glm::dvec3 map = integral(image, [](const glm::dvec3&) { return true; });
  glm::dvec3 spiral(0);  // a spherical spiral of as many equal areas
  constexpr int kPoints = 200'000;
  for (int i = 0; i < kPoints; ++i) {
    const double z = 1 - (2 * i + 1.0) / kPoints, a = i * 2.39996322972865, r = std::sqrt(1 - z * z);
    spiral += sky.background({r * std::cos(a), r * std::sin(a), z}) * (4 * kPi / kPoints);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(map[c] / spiral[c], 1, 2e-3);
  for (const float value : image.pixels) ASSERT_TRUE(value > 0 && value < 10);
}

}  // namespace
}  // namespace capcon
