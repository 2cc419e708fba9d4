// Direct lighting on the device against the reference, by the lights of shapes. Lights of a kind are put into
// one scene: kernels take longer to compile than to run.
#include "render/lit_scenes.h"

namespace capcon {
namespace {

using namespace testing;

const std::string kTwo = "\"bool twosided\" true ", kSquare = "\"integer indices\" [0 1 2 0 2 3] ",
                  kMesh = "Shape \"trianglemesh\" \"point3 P\" ";

void expect_lit(const std::string& what, const std::string& lights, double tolerance = 1e-4) {
  expect_agreement(what, look_at_patches(ground() + lights), lit_job(), tolerance, 2);
}

TEST(DirectLights, DisksAndEllipses) {
  expect_lit("disks", lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8") +
                          lamp("Translate .2 .8 1.2 Rotate 70 1 .2 0 Scale 1.4 .6 1 Shape \"disk\" \"float "
                               "radius\" .9 \"float "
                               "innerradius\" .5 \"float height\" .1",
                               kTwo) +
                          lamp("Translate 0 .4 1.8 Scale 1 1 -1 Rotate 20 0 1 0 Shape \"disk\" ") +
                          lamp("Translate .7 .4 1 Rotate 200 1 1 0 Shape \"disk\" \"float alpha\" 0 "));
}

TEST(DirectLights, RectanglesPointsAndDistantLights) {
  expect_lit(
      "rectangles",
      lamp(kMesh + "[-1 -.5 1.6 -.8 1 1.7 .9 1.2 1.2 .7 -.3 1.1] " + kSquare) +
          lamp(kMesh + "[-1 -.5 1 1 -.5 1 1 0 1.2 -1 0 1.2] " + kSquare, kTwo) +
          lamp(kMesh + "[.2 -.5 1.6 .2 1 1.7 .9 1.2 1.2 .9 -.3 1.1] " + kSquare + "\"float alpha\" 0 ") +
          "LightSource \"distant\" \"rgb L\" [2 1 .5] \"point3 from\" [1 .5 2] \"point3 to\" [0 0 0]\n"
          "LightSource \"point\" \"rgb I\" [2 1 .5] \"point3 from\" [-.3 .5 1.5]\n");
}

TEST(DirectLights, Spheres) {
  expect_lit(
      "spheres",
      lamp("Translate -.4 .3 1.4 Scale .5 .5 -.5 Shape \"sphere\" ") +
          lamp("Translate 300 200 900 Shape \"sphere\" \"float radius\" 40", "\"rgb scale\" [500 300 200]") +
          lamp("ReverseOrientation Translate .1 .2 1 Shape \"sphere\" \"float radius\" 9") +
          lamp("Translate .3 .3 .2 Shape \"sphere\" \"float radius\" .9 \"float alpha\" 0 ", kTwo) +
          lamp("Translate .5 -.3 .3 Shape \"sphere\" \"float radius\" .1", kTwo));
}

TEST(DirectLights, MeshesAndEllipsoids) {
  expect_lit("meshes", lamp(kMesh + "[-1 -.5 1.6 -.8 1 1.7 .9 1.2 1.2 .7 -.3 1.1 .2 .2 .8] \"integer "
                                    "indices\" [0 0 1 0 1 2 2 2 2 1 4 2 0 2 "
                                    "3 3 2 3] ") +
                           lamp("ReverseOrientation Translate .3 .2 1 Scale .5 .4 -.3 " + kMesh +
                                    "[-1 -1 -1 1 -1 -1 0 1 -1 0 0 1] \"normal N\" [-1 -1 -1 1 -1 -1 0 1 -1 0 "
                                    "0 1] \"integer indices\" [0 1 2 0 1 "
                                    "3 1 2 3 2 0 3]",
                                kTwo) +
                           lamp(kMesh + "[-1 -.5 1 1 -.5 1.2 0 1 1.1 -1 -.5 .5 -.5 -.5 .6 -.7 .1 .5] "
                                        "\"integer indices\" [0 1 2 3 5 4] "));
  expect_lit(
      "ellipsoids",
      lamp("Translate -.3 .4 1.1 Rotate 30 1 1 0 Scale .3 .8 .5 Shape \"sphere\" ") +
          lamp("ReverseOrientation Translate .6 -.4 .8 Rotate 30 1 1 0 Scale .3 .2 -.1 Shape \"sphere\" ",
               kTwo));
}

// Its triangles have numbers, but no primitives: what is numbered so hides the light as anything else does.
TEST(DirectLights, AHiddenMeshIsHiddenByTheFirstTriangles) {
  expect_lit("hidden mesh", lamp(kMesh + "[-1 -.5 1.6 -.8 1 1.7 .9 1.2 1.2 .7 -.3 1.1 .2 .2 1.3] \"integer "
                                         "indices\" [1 2 4 4 2 3 0 1 4 0 4 3] \"float alpha\" 0 "));
}

// Near the touching point distances are as small as the rounding of a float position is not.
TEST(DirectLights, ThatTouchOrCutTheGround) {
  expect_lit("touching",
             lamp("Translate .3 -.2 -.1 Shape \"sphere\" \"float radius\" .4", kTwo) +
                 lamp("Translate -.4 .4 .25 Shape \"sphere\" \"float radius\" .25") +
                 lamp("Translate 0 .7 .001 " + kMesh + "[-.5 0 0 .5 0 0 .5 0 .5 -.5 0 .5] " + kSquare, kTwo) +
                 lamp("Translate -.6 -.5 .02 Shape \"disk\" \"float radius\" .2", kTwo),
             1e-3);
}

TEST(DirectLights, FromWithinOneThatShinesInwards) {
  for (const std::string& ball : {std::string("Scale 3 3 3 "), std::string("Scale 3 2 4 ")}) {
    Scene scene =
        test::parse("LookAt 0 -1.5 .5 0 0 0 0 0 1 Camera \"perspective\" \"float fov\" 60 WorldBegin " +
                        patches({matte(0.6), "Material \"metal\" "}, 2) + matte(0.4) +
                        lamp("ReverseOrientation " + ball + "Shape \"sphere\" "),
                    {true, true, true});
    scene.film = {32, 24, ""};
    expect_agreement(ball, scene, lit_job(4), 1e-4, 2);
  }
}

}  // namespace
}  // namespace capcon
