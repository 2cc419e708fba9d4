#include <gtest/gtest.h>

#include "scene_text.h"

namespace capcon {
namespace {

using test::kTriangle;
using test::parse_world;

TEST(PbrtScope, AttributesComeBack) {
  const Scene scene = parse_world(
      "Material \"matte\" AttributeBegin Material \"metal\" Translate 1 0 0 ReverseOrientation\n"
      "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] Shape \"sphere\" AttributeEnd Shape \"sphere\"");
  const Shape& inner = scene.shapes[0];
  EXPECT_EQ(scene.materials.at(inner.material).type, "metal");
  EXPECT_EQ(inner.area_light, 0);
  EXPECT_TRUE(inner.reverse_orientation);
  EXPECT_EQ(inner.to_world[3].x, 1);
  EXPECT_EQ(inner.place.str(), "s.pbrt:3:43");
  const Shape& outer = scene.shapes[1];
  EXPECT_EQ(scene.materials.at(outer.material).type, "matte");
  EXPECT_EQ(outer.area_light, -1);
  EXPECT_FALSE(outer.reverse_orientation);
  EXPECT_EQ(outer.to_world[3].x, 0);
}

TEST(PbrtScope, InstancesComposeWithTheTransformInsideTheObject) {
  const Scene scene = parse_world(std::string("Translate 1 0 0 ObjectBegin \"o\" Scale 2 2 2\n") + kTriangle +
                                  "ObjectEnd\nTranslate 0 5 0 ObjectInstance \"o\" ObjectInstance \"o\"");
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].name, "o");
  ASSERT_EQ(scene.instances.size(), 2u);
  const glm::dmat4 whole = scene.instances[0].to_world * scene.objects[0].shapes[0].to_world;
  EXPECT_EQ(whole * glm::dvec4(1, 1, 1, 1), glm::dvec4(1 + 1 + 2, 5 + 2, 2, 1));
  EXPECT_TRUE(scene.shapes.empty());
  EXPECT_EQ(scene.unique_triangles(), 1u);
  EXPECT_EQ(scene.instanced_triangles(), 2u);
}

TEST(PbrtScope, ObjectsMayCloseAfterTheAttributesTheyOpenedIn) {
  const Scene scene = parse_world(
      std::string("AttributeBegin\nObjectBegin \"o\"\nAttributeBegin Translate 1 2 3\n") + kTriangle +
      "AttributeEnd\nAttributeEnd\nObjectEnd\nAttributeBegin ObjectInstance \"o\" AttributeEnd\n" +
      kTriangle);
  EXPECT_EQ(scene.objects.at(0).shapes.size(), 1u);
  EXPECT_EQ(scene.objects[0].shapes[0].to_world[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(scene.instances.at(0).to_world, glm::dmat4(1));
  EXPECT_EQ(scene.shapes.size(), 1u);
}

TEST(PbrtScope, AnObjectDefinedAgainServesLaterInstances) {
  const Scene scene = parse_world(
      "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd ObjectInstance \"o\"\n"
      "ObjectBegin \"o\" Shape \"disk\" ObjectEnd ObjectInstance \"o\"");
  EXPECT_EQ(scene.instances.at(0).object, 0u);
  EXPECT_EQ(scene.instances.at(1).object, 1u);
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(PbrtScope, LightsInObjectsAreLeftOutWithAWarning) {
  const Scene scene = parse_world(
      "ObjectBegin \"o\" AreaLightSource \"diffuse\" Shape \"sphere\" Shape \"sphere\" ObjectEnd "
      "ObjectInstance \"o\"");
  EXPECT_EQ(scene.objects.at(0).shapes.at(0).area_light, -1);
  ASSERT_EQ(scene.warnings.size(), 1u) << "each thing once";
}

TEST(PbrtScope, AttributeSetsWhatIsNotGiven) {
  const Scene scene = parse_world(
      "AttributeBegin Attribute \"shape\" \"float radius\" 3 Attribute \"material\" \"float roughness\" .25\n"
      "Shape \"sphere\" Shape \"sphere\" \"float radius\" 4 Material \"plastic\" AttributeEnd Shape "
      "\"sphere\"");
  EXPECT_EQ(scene.shapes.at(0).radius, 3);
  EXPECT_EQ(scene.shapes.at(1).radius, 4);
  EXPECT_EQ(scene.shapes.at(2).radius, 1);
  EXPECT_EQ(scene.materials.at(0).parameters.number("roughness", 0), 0.25);
}

TEST(PbrtScope, WhatFollowsTheWorldIsLeftOut) {
  const Scene scene = parse_world("Shape \"sphere\" WorldEnd\nNonsense");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], "s.pbrt:3:1: what follows WorldEnd is left out");
}

}  // namespace
}  // namespace capcon
