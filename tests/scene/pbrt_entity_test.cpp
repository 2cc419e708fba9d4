#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"

namespace capcon {
namespace {

using test::parse;
using test::parse_world;
using testing::ElementsAre;
using testing::Pointee;

TEST(PbrtOptions, CameraAndFilm) {
  const Scene scene = parse(
      "Camera \"perspective\" \"float fov\" 40 \"float screenwindow\" [-1 1 -2 2] \"float frameaspectratio\" "
      "[1.5]\n"
      "Film \"rgb\" \"integer xresolution\" 64 \"integer yresolution\" [48] \"string filename\" \"a b.exr\" "
      "WorldBegin");
  EXPECT_EQ(scene.camera.fov_degrees, 40);
  EXPECT_THAT(scene.camera.screen, ElementsAre(-1, 1, -2, 2));
  EXPECT_EQ(scene.camera.frame_aspect_ratio, 1.5);
  EXPECT_EQ(scene.film.width, 64);
  EXPECT_EQ(scene.film.height, 48);
  EXPECT_EQ(scene.film.filename, "a b.exr");
  EXPECT_EQ(scene.name, "s");
}

TEST(PbrtOptions, OlderSpellings) {
  const Scene scene = parse(
      "Film \"image\" \"integer xresolution\" [8]\nCamera \"perspective\" \"float halffov\" "
      "[20]\nPixelFilter \"box\"\n"
      "Sampler \"stratified\" \"bool jitter\" [\"false\"]\nSurfaceIntegrator \"path\"\nVolumeIntegrator "
      "\"single\"\n"
      "Renderer \"sampler\"\nAccelerator \"kdtree\"\nFilter \"box\"\nIntegrator "
      "\"path\"\nWorldBegin\nWorldEnd\n");
  EXPECT_EQ(scene.camera.fov_degrees, 40);
  EXPECT_EQ(scene.film.width, 8);
  EXPECT_EQ(scene.film.height, 480);
}

TEST(PbrtOptions, WhatIsNotSupportedWarnsOnce) {
  const Scene scene = parse(
      "Option \"bool disablepixeljitter\" true ColorSpace \"rec2020\"\n"
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"\" \"fog\"\n"
      "Camera \"perspective\" \"float lensradius\" .1 Film \"rgb\" \"float cropwindow\" [0 .5 0 .5]\n"
      "WorldBegin MediumInterface \"fog\" \"\" Shape \"cylinder\" Shape \"cylinder\" Shape \"sphere\"");
  EXPECT_THAT(scene.warnings,
              ElementsAre("s.pbrt:1:39: the colour space \"rec2020\" is left out: colours are taken as sRGB",
                          "s.pbrt:2:1: media are left out: space is empty",
                          "s.pbrt:3:22: depth of field is left out: the lens is a point",
                          "s.pbrt:3:55: the film's crop is left out: the whole image is rendered",
                          "s.pbrt:4:37: shape \"cylinder\" is not supported and was left out"));
  EXPECT_EQ(scene.shapes.size(), 1u);
}

TEST(PbrtEntities, ParametersOfEveryType) {
  const Scene scene = parse_world(
      "LightSource \"infinite\" \"rgb L\" [1 .5 2e-1] \"color scale\" [3 3 3] \"xyz I\" [1 2 3] \"integer "
      "nsamples\" 4\n"
      "\"string mapname\" [\"../a.exr\"] \"bool on\" true \"bool off\" [\"false\"] \"bool both\" [ true "
      "\"false\" ] # comment ]\n"
      "\"blackbody temperature\" 6500 \"spectrum s\" [400 1 700 2] \"spectrum named\" \"stdillum-D65\" "
      "\"point2 uv\" [1 2]\n"
      "  \"  float   spaced \" +1.5 \"vector3 v\" [1 -2 .5e1] \"float tiny\" 1e-999 \"string quoted\" "
      "\"a\\\"b\\n#\"");
  const Parameters& p = scene.lights.at(0).parameters;
  EXPECT_EQ(scene.lights[0].type, "infinite");
  EXPECT_EQ(p.entries.at("L").type, "rgb");
  EXPECT_THAT(p.numbers("L"), Pointee(ElementsAre(1, 0.5, 0.2)));
  EXPECT_THAT(p.numbers("scale"), Pointee(ElementsAre(3, 3, 3)));
  EXPECT_EQ(p.number("nsamples", 0), 4);
  EXPECT_EQ(p.string("mapname", ""), "../a.exr");
  EXPECT_TRUE(p.boolean("on", false));
  EXPECT_FALSE(p.boolean("off", true));
  EXPECT_TRUE(p.boolean("both", false));
  EXPECT_EQ(p.number("temperature", 0), 6500);
  EXPECT_THAT(p.numbers("s"), Pointee(ElementsAre(400, 1, 700, 2)));
  EXPECT_EQ(p.string("named", ""), "stdillum-D65");
  EXPECT_EQ(p.number("spaced", 0), 1.5);
  EXPECT_THAT(p.numbers("v"), Pointee(ElementsAre(1, -2, 5)));
  EXPECT_EQ(p.number("tiny", 1), 0);
  EXPECT_EQ(p.string("quoted", ""), "a\"b\n#");
  EXPECT_EQ(p.number("absent", 7), 7);
  EXPECT_EQ(p.string("absent", "x"), "x");
  EXPECT_EQ(p.numbers("absent"), nullptr);
  EXPECT_EQ(test::error_of([&] { p.number("mapname", 0); }), "s.pbrt:3:1: \"mapname\" must be a number");
}

TEST(PbrtEntities, AParameterGivenTwiceKeepsItsFirstValue) {
  const Scene scene = parse_world("Material \"matte\" \"float sigma\" 1 \"float sigma\" 2");
  EXPECT_EQ(scene.materials.at(0).parameters.number("sigma", 0), 1);
}

TEST(PbrtEntities, LightsKeepTheirTransform) {
  const Scene scene =
      parse_world("Translate 1 2 3 LightSource \"point\" AreaLightSource \"area\" \"color L\" [1 1 1]");
  EXPECT_EQ(scene.lights.at(0).to_world[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(scene.area_lights.at(0).type, "area");
}

TEST(PbrtEntities, TexturesOfBothKinds) {
  const Scene scene = parse_world(
      "Texture \"a\" \"color\" \"imagemap\" \"string filename\" \"missing.png\" Texture \"b\" \"float\" "
      "\"constant\"\n"
      "Texture \"c\" \"spectrum\" \"scale\" \"texture tex\" \"a\"");
  ASSERT_EQ(scene.textures.size(), 3u);
  EXPECT_EQ(scene.textures[0].values, "spectrum");
  EXPECT_EQ(scene.textures[0].type, "imagemap");
  EXPECT_EQ(scene.textures[1].values, "float");
  EXPECT_EQ(scene.textures[1].name, "b");
  EXPECT_EQ(scene.textures[2].parameters.string("tex", ""), "a");
}

TEST(PbrtEntities, NamedMaterials) {
  const Scene scene = parse_world(
      "NamedMaterial \"later\" Shape \"sphere\" MakeNamedMaterial \"now\" \"string type\" \"glass\" "
      "NamedMaterial \"now\"\n"
      "Shape \"sphere\" MakeNamedMaterial \"later\" \"string type\" \"metal\" NamedMaterial \"later\" Shape "
      "\"sphere\"\n"
      "MakeNamedMaterial \"now\" \"string type\" \"matte\" NamedMaterial \"now\" Shape \"sphere\"");
  const auto type = [&](int shape) { return scene.materials.at(scene.shapes.at(shape).material).type; };
  EXPECT_EQ(type(0), "metal");
  EXPECT_EQ(type(1), "glass");
  EXPECT_EQ(type(2), "metal");
  EXPECT_EQ(type(3), "matte");
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(PbrtEntities, UndefinedMaterialsBecomeTheDefault) {
  const Scene scene = parse_world(
      "NamedMaterial \"golld\" Shape \"sphere\" MakeNamedMaterial \"gold\" \"string type\" \"metal\" "
      "NamedMaterial \"gold\"\n"
      "Shape \"sphere\" ObjectBegin \"o\" NamedMaterial \"golld\" Shape \"sphere\" Material \"matte\" Shape "
      "\"disk\" ObjectEnd");
  EXPECT_EQ(scene.shapes.at(0).material, -1);
  EXPECT_EQ(scene.materials.at(scene.shapes.at(1).material).name, "gold");
  EXPECT_EQ(scene.objects.at(0).shapes.at(0).material, -1);
  EXPECT_EQ(scene.materials.at(scene.objects[0].shapes.at(1).material).type, "matte");
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_THAT(scene.warnings,
              testing::Contains("s.pbrt:2:1: there is no material named \"golld\", the default is used; "
                                "did you mean \"gold\"?"));
}

}  // namespace
}  // namespace capcon
