#include "reference/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/hemisphere.h"

namespace capcon {
namespace {

using reference::View;

void expect_direction(const View& view, double x, double y, const glm::dvec3& expected) {
  const glm::dvec3 d = view.ray(x, y).direction;
  const glm::dvec3 e = glm::normalize(expected);
  EXPECT_LT(glm::length(d - e), 1e-14) << d.x << " " << d.y << " " << d.z;
}

TEST(View, SquareFilm) {
  Camera camera;
  camera.fov_degrees = 90;
  const View view(camera, {256, 256, ""});
  expect_direction(view, 128, 128, {0, 0, 1});
  expect_direction(view, 0, 0, {-1, 1, 1});  // the upper left corner looks left and up
  expect_direction(view, 256, 256, {1, -1, 1});
  expect_direction(view, 0.5, 128, {-255.0 / 256, 0, 1});
}

TEST(View, TheAngleSpansTheShorterAxis) {
  Camera camera;
  camera.fov_degrees = 60;
  const double t = std::tan(M_PI / 6);
  expect_direction(View(camera, {200, 100, ""}), 200, 0, {2 * t, t, 1});
  expect_direction(View(camera, {100, 200, ""}), 100, 0, {t, 2 * t, 1});
}

TEST(View, FrameAspectAndScreenWindow) {
  Camera camera;
  camera.fov_degrees = 90;
  camera.frame_aspect_ratio = 0.5;
  expect_direction(View(camera, {100, 100, ""}), 100, 0, {1, 2, 1});
  camera.screen = {-1, 3, 0, 0.5};
  expect_direction(View(camera, {100, 100, ""}), 25, 100, {0, 0, 1});
  expect_direction(View(camera, {100, 100, ""}), 100, 0, {3, 0.5, 1});
}

TEST(View, CameraToWorldWithMirrorAndScale) {
  Camera camera;
  camera.fov_degrees = 90;
  // Columns: right = -x (mirrored), up = z, forward = y, all doubled; at (1, 2, 3).
  camera.camera_to_world = glm::dmat4(-2, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 1, 2, 3, 1);
  const View view(camera, {2, 2, ""});
  EXPECT_EQ(view.ray(1, 1).origin, glm::dvec3(1, 2, 3));
  expect_direction(view, 1, 1, {0, 1, 0});
  expect_direction(view, 2, 1, {-1, 1, 0});
  expect_direction(view, 1, 0, {0, 1, 1});
  EXPECT_NEAR(glm::length(view.ray(2, 0).direction), 1, 1e-15);
}

TEST(Hemisphere, ConcentricMapAtKnownPlaces) {
  const auto near = [](double u, double v, double x, double y) {
    const glm::dvec2 d = reference::concentric_disk(u, v);
    EXPECT_NEAR(d.x, x, 1e-15);
    EXPECT_NEAR(d.y, y, 1e-15);
  };
  const double s = std::sqrt(0.5);
  near(0.5, 0.5, 0, 0);
  near(1, 0.5, 1, 0);
  near(0.5, 1, 0, 1);
  near(0, 0.5, -1, 0);
  near(0.5, 0, 0, -1);
  near(1, 1, s, s);
  near(0, 1, -s, s);
  near(0, 0, -s, -s);
  near(1, 0, s, -s);
  near(0.75, 0.625, 0.5 * std::cos(M_PI / 8), 0.5 * std::sin(M_PI / 8));
}

TEST(Hemisphere, AreasAndMomentsOfTheCosine) {
  // Midpoint rule: every cell has equal weight, so mean z is 2/3 and mean z^2 is 1/2 for the density cos /
  // pi.
  constexpr int kSide = 400;
  double z = 0, z2 = 0, x2 = 0, quadrant = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::dvec3 d = reference::cosine_hemisphere((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    EXPECT_NEAR(glm::length(d), 1, 1e-12);
    z += d.z;
    z2 += d.z * d.z;
    x2 += d.x * d.x;
    quadrant += d.x > 0 && d.y > 0;
  }
  const double n = kSide * kSide;
  EXPECT_NEAR(z / n, 2.0 / 3, 1e-4);
  EXPECT_NEAR(z2 / n, 0.5, 1e-4);
  EXPECT_NEAR(x2 / n, 0.25, 1e-4);
  EXPECT_NEAR(quadrant / n, 0.25, 1e-3);
}

TEST(Hemisphere, FramesAreOrthonormalAndRightHanded) {
  for (int i = 0; i < 2000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 2000, phi = 2.4 * i, r = std::sqrt(1 - z * z);
    glm::dvec3 n(r * std::cos(phi), r * std::sin(phi), z);
    if (i == 0) n = {0, 0, 1};
    if (i == 1) n = {0, 0, -1};
    if (i == 2) n = {0, 1, -0.0};
    const glm::dvec3 t = reference::around_normal(n, {1, 0, 0});
    const glm::dvec3 b = reference::around_normal(n, {0, 1, 0});
    EXPECT_LT(glm::length(glm::cross(t, b) - n), 1e-14);
    EXPECT_NEAR(glm::length(t), 1, 1e-14);
    EXPECT_NEAR(glm::dot(t, b), 0, 1e-14);
    EXPECT_EQ(reference::around_normal(n, {0, 0, 1}), n);
  }
}

}  // namespace
}  // namespace capcon
