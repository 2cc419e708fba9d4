#include "shading/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene_text.h"

namespace capcon {
namespace {

using test::parse_world;

/// A scene with one texture, whose image is 2 x 2 and grey: 0.1 0.2 above 0.3 0.4.
Scene with_image(const std::string& parameters) {
  Scene scene =
      parse_world("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.exr\" " + parameters);
  Image image(2, 2, 1);
  image.pixels = {0.1f, 0.2f, 0.3f, 0.4f};
  scene.images.push_back({"a.exr", image});
  scene.textures[0].image = 0;
  return scene;
}

double at(const Scene& scene, double u, double v) {
  std::vector<std::string> said;
  const Texture texture = read_texture(scene, scene.textures.back(), glm::dvec3(0.5), said);
  EXPECT_TRUE(said.empty());
  return lookup(texture, scene.images, {u, v}).x;
}

TEST(Texture, BilinearWithVUpwards) {
  const Scene scene = with_image("");
  EXPECT_NEAR(at(scene, 0.25, 0.75), 0.1, 1e-6);
  EXPECT_NEAR(at(scene, 0.75, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(at(scene, 0.25, 0.25), 0.3, 1e-6);
  EXPECT_NEAR(at(scene, 0.75, 0.25), 0.4, 1e-6);
  EXPECT_NEAR(at(scene, 0.5, 0.5), 0.25, 1e-6);
  EXPECT_NEAR(at(scene, 0.35, 0.75), 0.8 * 0.1 + 0.2 * 0.2, 1e-6);
}

TEST(Texture, WrapsAsAsked) {
  EXPECT_NEAR(at(with_image(""), 3.25, -1.25), 0.1, 1e-6);  // v = 0.75
  EXPECT_NEAR(at(with_image(""), 1, 0.75), 0.15, 1e-6);     // half way from the right texel to the left one
  EXPECT_NEAR(at(with_image("\"string wrap\" \"clamp\""), 9, -9), 0.4, 1e-6);
  EXPECT_NEAR(at(with_image("\"string wrap\" \"clamp\""), 1, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(at(with_image("\"string wrap\" \"black\""), 1.6, 0.75), 0, 1e-6);
  EXPECT_NEAR(at(with_image("\"string wrap\" \"black\""), 1, 0.75), 0.1, 1e-6);
  EXPECT_TRUE(std::isfinite(at(with_image(""), 1e300, 1e30)));
  EXPECT_TRUE(std::isfinite(at(with_image("\"string wrap\" \"clamp\""), -1e300, 1e300)));
}

TEST(Texture, ScaleOffsetInvertAndFactor) {
  EXPECT_NEAR(at(with_image("\"float uscale\" 2 \"float udelta\" 0.25"), 0.25, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(at(with_image("\"float scale\" 3"), 0.25, 0.75), 0.3, 1e-6);
  EXPECT_NEAR(at(with_image("\"bool invert\" true"), 0.25, 0.75), 0.9, 1e-6);
  EXPECT_NEAR(
      at(with_image("Texture \"s\" \"spectrum\" \"scale\" \"texture tex1\" \"t\" \"rgb tex2\" [.5 .5 .5]"),
         0.25, 0.75),
      0.05, 1e-6);
  EXPECT_NEAR(at(with_image("Texture \"s\" \"spectrum\" \"scale\" \"texture tex\" \"t\" \"float scale\" 2"),
                 0.25, 0.75),
              0.2, 1e-6);
}

TEST(Texture, AverageIsTheMeanOfTheImage) {
  std::vector<std::string> said;
  Scene scene = with_image("\"float scale\" 2");
  EXPECT_NEAR(read_texture(scene, scene.textures[0], glm::dvec3(0.5), said).average.y, 0.5, 1e-6);
  Scene scaled =
      with_image("Texture \"s\" \"spectrum\" \"scale\" \"texture tex1\" \"t\" \"rgb tex2\" [.5 .5 .5]");
  EXPECT_NEAR(read_texture(scaled, scaled.textures[1], glm::dvec3(0.5), said).average.y, 0.125, 1e-6);
  scene.textures[0].image = -1;  // not found
  EXPECT_EQ(read_texture(scene, scene.textures[0], glm::dvec3(0.7), said).average.y, 0.7);
}

TEST(Texture, LinearPngIsEncodedBack) {
  Scene scene = with_image("\"string encoding\" \"linear\"");
  scene.images[0].file = "a.png";
  // sRGB of 0.1 is 0.34919.
  EXPECT_NEAR(at(scene, 0.25, 0.75), 0.34919, 1e-4);
}

TEST(Texture, WhatIsNoImageBecomesItsMean) {
  std::vector<std::string> said;
  const Scene scene = parse_world(
      "Texture \"c\" \"spectrum\" \"constant\" \"rgb value\" [1 0 0]\n"
      "Texture \"k\" \"spectrum\" \"checkerboard\" \"texture tex1\" \"c\" \"rgb tex2\" [0 0 1]\n"
      "Texture \"m\" \"spectrum\" \"mix\" \"texture tex1\" \"c\" \"rgb tex2\" [0 0 1] \"float amount\" .25\n"
      "Texture \"n\" \"spectrum\" \"mix\" \"texture tex1\" \"c\" \"rgb tex2\" [0 0 1] \"float amount\" 9\n"
      "Texture \"f\" \"spectrum\" \"fbm\"");
  const auto average = [&](int i) {
    return read_texture(scene, scene.textures[i], glm::dvec3(0.3), said).average;
  };
  EXPECT_EQ(average(1), glm::dvec3(0.5, 0, 0.5));
  EXPECT_EQ(average(2), glm::dvec3(0.75, 0, 0.25));
  EXPECT_EQ(average(3), glm::dvec3(0, 0, 1));  // amounts are bounded
  EXPECT_EQ(average(4), glm::dvec3(0.3));
  EXPECT_EQ(said.size(), 2u);  // the mix of constants is exact
}

TEST(Texture, MistakesAreNamed) {
  std::vector<std::string> said;
  const Scene scene = parse_world(
      "Texture \"a\" \"spectrum\" \"scale\" \"texture tex1\" \"a\"\nTexture \"b\" \"spectrum\" \"scale\" "
      "\"texture "
      "tex1\" \"none\"");
  const auto error = [&](int i) {
    return test::error_of([&] { read_texture(scene, scene.textures[i], glm::dvec3(0.5), said); });
  };
  EXPECT_EQ(error(0), "s.pbrt:2:1: the texture \"a\" names itself");
  EXPECT_EQ(error(1), "s.pbrt:3:32: there is no texture named \"none\"");
}

TEST(Texture, NamesAreLookedUpByKind) {
  const Scene scene = parse_world(
      "Texture \"a\" \"spectrum\" \"constant\" Texture \"a\" \"float\" \"constant\" \"float value\" 2");
  EXPECT_EQ(find_texture(scene, "a", "spectrum"), &scene.textures[0]);
  EXPECT_EQ(find_texture(scene, "a", "float"), &scene.textures[1]);
  EXPECT_EQ(find_texture(scene, "b", "float"), nullptr);
}

}  // namespace
}  // namespace capcon
