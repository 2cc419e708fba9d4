#include <gtest/gtest.h>

#include <cmath>

#include "scene_text.h"

namespace capcon {
namespace {

using test::parse;
using test::parse_world;

glm::dvec3 at(const glm::dmat4& transform, double x, double y, double z) {
  return glm::dvec3(transform * glm::dvec4(x, y, z, 1));
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-12) << "component " << i;
}

/// Where a sphere's point ends when the world holds these directives before it.
glm::dvec3 moved(const std::string& directives, double x, double y, double z) {
  return at(parse_world(directives + " Shape \"sphere\"").shapes.at(0).to_world, x, y, z);
}

TEST(PbrtTransform, TheLatestDirectiveActsFirst) {
  expect_near(moved("Translate 1 2 3", 1, 1, 1), {2, 3, 4});
  expect_near(moved("Scale 2 3 -4", 1, 1, 1), {2, 3, -4});
  expect_near(moved("Translate 1 0 0 Scale 2 2 2", 1, 1, 1), {3, 2, 2});
  expect_near(moved("Scale 2 2 2 Translate 1 0 0", 1, 1, 1), {4, 2, 2});
  expect_near(moved("Translate 9 9 9 Identity", 1, 2, 3), {1, 2, 3});
}

TEST(PbrtTransform, RotationsTurnAsInARightHandedFrame) {
  expect_near(moved("Rotate 90 0 0 1", 1, 0, 0), {0, 1, 0});
  expect_near(moved("Rotate 90 1 0 0", 0, 0, 1), {0, -1, 0});
  expect_near(moved("Rotate -90 0 2 0", 1, 0, 0), {0, 0, 1});
  expect_near(moved("Rotate 120 1 1 1", 1, 2, 3), {3, 1, 2});
  const double c = std::cos(0.5235987755982988), s = std::sin(0.5235987755982988);
  expect_near(moved("Rotate 30 0 1 0", 1, 5, 0), {c, 5, -s});
  EXPECT_EQ(moved("Rotate 450 0 0 1", 1, 0, 0), glm::dvec3(0, 1, 0)) << "quarter turns are exact";
}

TEST(PbrtTransform, MatricesComeColumnByColumn) {
  const std::string matrix = "[1 0 0 0  0 0 1 0  0 -1 0 0  7 8 9 1]";
  expect_near(moved("Translate 5 5 5 Transform " + matrix, 1, 2, 3), {8, 5, 11});
  expect_near(moved("Translate 5 5 5 ConcatTransform " + matrix, 1, 2, 3), {13, 10, 16});
  expect_near(moved("Transform 1 0 0 0 0 1 0 0 0 0 1 0 4 5 6 1", 0, 0, 0), {4, 5, 6});
}

TEST(PbrtTransform, LookAtIsLeftHanded) {
  // From the origin along +x with y up, the right of the image is cross(up, forward) = -z.
  const glm::dmat4 camera =
      parse("LookAt 0 0 0  1 0 0  0 1 0 Camera \"perspective\" WorldBegin").camera.camera_to_world;
  expect_near(at(camera, 1, 0, 0), {0, 0, -1});
  expect_near(at(camera, 0, 1, 0), {0, 1, 0});
  expect_near(at(camera, 0, 0, 1), {1, 0, 0});
  EXPECT_NEAR(glm::determinant(glm::dmat3(camera)), 1, 1e-12)
      << "both spaces are left-handed, so nothing is mirrored";
}

TEST(PbrtTransform, TheCameraIsTheInverseOfTheCurrentTransform) {
  const Scene scene =
      parse("Scale -1 1 1 LookAt 1 2 3  1 2 13  0 3 0 Camera \"perspective\" WorldBegin Shape \"sphere\"");
  // World to camera is mirror * translate(-1,-2,-3).
  expect_near(at(scene.camera.camera_to_world, 0, 0, 0), {1, 2, 3});
  expect_near(at(scene.camera.camera_to_world, 1, 0, 0), {0, 2, 3});
  expect_near(at(scene.camera.camera_to_world, 0, 0, 1), {1, 2, 4});
  EXPECT_EQ(scene.shapes[0].to_world, glm::dmat4(1)) << "WorldBegin starts anew";
}

TEST(PbrtTransform, CoordinateSystemsAreKeptByName) {
  const Scene scene = parse(
      "Translate 0 0 -5 Camera \"perspective\" WorldBegin Translate 1 0 0 CoordinateSystem \"here\" Scale 3 "
      "3 3\n"
      "CoordSysTransform \"here\" Shape \"sphere\" CoordSysTransform \"camera\" Shape \"sphere\"\n"
      "CoordSysTransform \"world\" Shape \"sphere\"");
  expect_near(at(scene.shapes[0].to_world, 0, 0, 0), {1, 0, 0});
  expect_near(at(scene.shapes[1].to_world, 0, 0, 0), {0, 0, 5});
  expect_near(at(scene.shapes[2].to_world, 0, 0, 0), {0, 0, 0});
}

TEST(PbrtTransform, TransformScopesBringBackTheTransformAlone) {
  const Scene scene = parse_world(
      "TransformBegin Translate 1 0 0 ReverseOrientation Shape \"sphere\" TransformEnd Shape \"sphere\"");
  expect_near(at(scene.shapes[0].to_world, 0, 0, 0), {1, 0, 0});
  expect_near(at(scene.shapes[1].to_world, 0, 0, 0), {0, 0, 0});
  EXPECT_TRUE(scene.shapes[1].reverse_orientation);
}

TEST(PbrtTransform, MotionKeepsItsStart) {
  const Scene scene = parse(
      "TransformTimes 0 1 Camera \"perspective\" WorldBegin AttributeBegin Translate 1 0 0\n"
      "ActiveTransform EndTime Translate 5 0 0 ActiveTransform All Translate 0 1 0 Shape \"sphere\" "
      "AttributeEnd\n"
      "ActiveTransform StartTime Translate 0 0 2 Shape \"sphere\"");
  expect_near(at(scene.shapes[0].to_world, 0, 0, 0), {1, 1, 0});
  expect_near(at(scene.shapes[1].to_world, 0, 0, 0), {0, 0, 2});
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], "s.pbrt:2:17: motion is left out: everything stands where it starts");
}

}  // namespace
}  // namespace capcon
