#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "render/explain.h"
#include "render/features.h"
#include "render/renderer.h"
#include "render/renderer_state.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

RendererOptions lavapipe(bool keep_everything = false) {
  return {.device = "lavapipe", .validate = true, .keep_everything = keep_everything};
}

AmbientOcclusionJob job(PixelPosition position = PixelPosition::centre) {
  AmbientOcclusionJob j;
  j.radius = 1;
  j.position = position;
  return j;
}

// Whatever a scene does not have or need is left out; the image with everything is the same, bit by bit.
TEST(Features, KeepingEverythingChangesNoBit) {
  for (const Scene& scene : {testing::random_soup(400, 1), testing::round_things()}) {
    Renderer needed(scene, lavapipe()), everything(scene, lavapipe(true));
    for (const auto position : {PixelPosition::centre, PixelPosition::jittered}) {
      EXPECT_EQ(needed.render(job(position)).image.pixels, everything.render(job(position)).image.pixels);
    }
  }
}

TEST(Features, FollowFromTheScene) {
  const auto of = [](const Scene& scene, PixelPosition position, const std::string& instancing = "auto") {
    const Job j = job(position);
    return needed_features(scene, &j, instancing);
  };
  EXPECT_FALSE(of(testing::random_soup(9, 1), PixelPosition::centre).quadrics);
  EXPECT_TRUE(of(testing::round_things(), PixelPosition::centre).quadrics);
  Scene only_instanced = testing::round_things();
  only_instanced.shapes.resize(1);
  EXPECT_TRUE(of(only_instanced, PixelPosition::centre).quadrics);
  EXPECT_FALSE(of(testing::round_things(), PixelPosition::centre).two_level);
  EXPECT_TRUE(of(testing::round_things(), PixelPosition::centre, "two-level").two_level);
  EXPECT_FALSE(of(testing::round_things(), PixelPosition::centre).jittered);
  EXPECT_TRUE(of(testing::round_things(), PixelPosition::jittered).jittered);
  EXPECT_FALSE(of(testing::round_things(), PixelPosition::centre).shading);
  const Job direct = DirectLightingJob{};
  EXPECT_TRUE(needed_features(testing::round_things(), &direct, "auto").shading);
}

TEST(Features, TreesAreCutForManyRays) {
  const Scene scene = testing::random_soup(400, 1);  // 1,920 pixels: 4.8 rays a triangle and sample
  const auto with = [](std::uint32_t samples) {
    auto j = job();
    j.samples = samples;
    return Job(j);
  };
  Job j = with(8);
  EXPECT_FALSE(wants_best_tree(scene, false, &j, "auto"));
  EXPECT_TRUE(wants_best_tree(scene, false, &j, "best"));
  j = with(64);
  EXPECT_TRUE(wants_best_tree(scene, false, &j, "auto"));
  EXPECT_FALSE(wants_best_tree(scene, false, &j, "fast"));
  EXPECT_TRUE(wants_best_tree(scene, false, nullptr, "auto"));
}

TEST(Features, WhatIsNotNeededHasNoBuffer) {
  Renderer needed(testing::random_soup(400, 1), lavapipe()),
      everything(testing::random_soup(400, 1), lavapipe(true));
  constexpr std::size_t kEmpty = 16;  // so that it can be bound
  EXPECT_EQ(needed.state().details.bytes(), kEmpty);
  EXPECT_EQ(needed.state().shading.bytes(), kEmpty);
  EXPECT_EQ(needed.state().instances.bytes(), kEmpty);
  EXPECT_EQ(everything.state().details.bytes(), 400u * 16 * 5);
  EXPECT_EQ(everything.state().shading.bytes(), 48u * 40 * 32);
  EXPECT_EQ(everything.state().instances.bytes(), 128u);
}

// Two triangles with normals, uvs, a textured material and an environment: only --keep-everything opens their
// files.
TEST(Features, ExplainSaysWhatWasLeftOut) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "capcon-explain";
  std::filesystem::create_directories(folder);
  write_exr(folder / "sky.exr", Image(4, 2, 3));
  std::ofstream(folder / "scene.pbrt") << R"(
    LookAt 0 1 -4  0 0 0  0 1 0
    Camera "perspective" "float fov" 50
    Film "rgb" "integer xresolution" 32 "integer yresolution" 24
    WorldBegin
    LightSource "infinite" "string filename" "sky.exr"
    Texture "wood" "spectrum" "imagemap" "string filename" "missing.png"
    Material "diffuse" "texture reflectance" "wood"
    Shape "trianglemesh" "point3 P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2  0 1 0] "integer indices" [0 1 2 0 2 3 0 1 4]
      "normal N" [0 1 0 0 1 0 0 1 0 0 1 0 0 0 -1] "point2 uv" [0 0 1 0 1 1 0 1 0.5 0.5]
  )";
  const Explanation e = explain((folder / "scene.pbrt").string(), 0, 0, job(), lavapipe(), 1);
  EXPECT_TRUE(e.identical);
  ASSERT_EQ(e.rows.size(), 9u);
  for (const FeatureRow& row : e.rows) EXPECT_FALSE(row.used) << row.name;
  EXPECT_EQ(e.rows[0].in_scene, "5 vertices with normals");
  EXPECT_EQ(e.rows[1].in_scene, "5 vertices with uvs");
  EXPECT_EQ(e.rows[3].in_scene, "1 texture, no image files found");
  EXPECT_EQ(e.rows[4].in_scene, "1 environment map");
  EXPECT_EQ(e.everything.scene_bytes - e.needed.scene_bytes, 5u * 20 + 4 * 2 * 3 * 4);
  EXPECT_GT(e.everything.device_bytes, e.needed.device_bytes);
  EXPECT_NE(to_text(e).find("left out: no file opened"), std::string::npos);
  std::filesystem::remove_all(folder);
}

// Rows rendered alone are those of the whole image; more pixels than a band holds are rendered in several.
TEST(RenderRows, GiveTheBitsOfTheWholeImage) {
  const Scene scene = testing::random_soup(300, 7);
  Renderer renderer(scene, lavapipe());
  for (const auto position : {PixelPosition::centre, PixelPosition::jittered}) {
    const Image whole = renderer.render(job(position)).image;
    for (const auto& [first, rows] : {std::pair{0, 1}, {7, 20}, {39, 1}}) {
      const Image part = renderer.render_rows(job(position), first, rows).image;
      ASSERT_EQ(part.height, rows);
      EXPECT_TRUE(
          std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + first * whole.width));
    }
  }
}

TEST(RenderRows, AnImageLargerThanABand) {
  Scene scene = testing::random_soup(20, 8, 1500, 1500);
  auto j = job();
  j.samples = 1;
  Renderer renderer(scene, {.device = "lavapipe"});
  ASSERT_LT(renderer.state().band_pixels, 1500u * 1500u);
  const Image whole = renderer.render(j).image;
  const Image last = renderer.render_rows(j, 1450, 50).image;
  EXPECT_TRUE(std::equal(last.pixels.begin(), last.pixels.end(), whole.pixels.begin() + 1450 * 1500));
}

}  // namespace
}  // namespace capcon
