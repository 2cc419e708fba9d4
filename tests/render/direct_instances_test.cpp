// Direct lighting of instanced objects: one tree over all, and two levels.
#include "render/lit_scenes.h"
#include "render/renderer_state.h"

namespace capcon {
namespace {

using namespace testing;

/// Curved sheets of several materials and a ball, small and turned, stretched and mirrored.
Scene instanced(const std::string& lights) {
  const std::string sheet =
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 0 -1 .3 1 -1 0 -1 1 0 0 1 .3 1 1 0] \"integer indices\" "
      "[0 1 3 1 4 3 1 2 4 2 5 4] "
      "\"normal N\" [-1 0 1 0 0 2 1 0 1 -1 0 1 0 0 2 1 0 1] \"point2 uv\" [0 0 1 0 2 0 0 1 1 1 2 1] ";
  std::string text =
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture\"\n"
      "ObjectBegin \"a\" Material \"diffuse\" \"texture reflectance\" \"t\" " +
      sheet + "Material \"metal\" \"float roughness\" .2 Translate 0 0 .6 Scale .5 .5 -.5 Rotate 30 1 0 0 " +
      sheet + "ObjectEnd ObjectBegin \"b\" " + matte(0.8) + sheet +
      "Translate .5 0 .5 Shape \"sphere\" \"float radius\" .3 ObjectEnd ";
  for (int i = 0; i < 9; ++i) {
    const auto random = [&](int k) { return std::to_string(0.8 * uniform64(5, i, k) - 0.4); };
    text += within("Translate " + std::to_string(i % 3 - 1.0) + " " + std::to_string(i / 3 - 1.0) +
                   " 0 Rotate 40 " + random(0) + " " + random(1) + " .2 Scale " + (i % 2 ? "-.5" : ".4") +
                   " .25 1.1 ObjectInstance \"" + (i % 3 ? "a" : "b") + "\"");
  }
  Scene scene = look_at_patches(patches({matte(0.5)}, 1) + text + lights);
  put_images(scene, {{"picture", random_image(7, 5, 1)}});
  return scene;
}

TEST(DirectInstances, AgreeWithTheReferenceOnBothLevels) {
  const std::string disk = lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8"),
                    mesh = lamp(
                        "Shape \"trianglemesh\" \"point3 P\" [-1 -.5 1.6 -.8 1 1.7 .9 1.2 1.2] \"integer "
                        "indices\" [0 1 2] ");
  for (const bool two : {false, true}) {
    const Scene scene = instanced(two ? disk + mesh : disk);
    const char* levels = two ? "two-level" : "flat";
    Renderer renderer(scene, lavapipe("auto", levels));
    const Reference reference(scene);
    EXPECT_EQ(renderer.state().instance_count, two ? 10u : 0u);
    DirectLightingJob job = lit_job();
    expect_agreement(levels, renderer, reference, job, 1e-4, 4);  // silhouettes of small sheets
    job.position = PixelPosition::jittered;
    job.image_samples = 2;
    expect_agreement(levels, renderer, reference, job, 1e-4, 8);
  }
}

// A triangle that is stretched by its instance: normals are made unit vectors in the world before they are
// weighed.
TEST(DirectInstances, NormalsAreWeighedInTheWorld) {
  Scene scene = test::look_at_origin(
      matte(1) +
      "ObjectBegin \"o\" Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"integer "
      "indices\" [0 1 2 0 2 3] "
      "\"normal N\" [0 0 1 0 0 1 .8 0 .6 0 0 1] ObjectEnd Scale 4 1 1 ObjectInstance \"o\" Identity "
      "LightSource \"distant\" \"rgb L\" [1 1 1] \"point3 to\" [0 0 0] \"point3 from\" [0 0 1]\n");
  const glm::dvec3 leaning = glm::normalize(glm::dvec3(0.8 / 4, 0, 0.6)), up(0, 0, 1);
  const double expected = glm::normalize(leaning + up).z / std::numbers::pi;
  for (const char* levels : {"flat", "two-level"}) {
    Renderer renderer(scene, lavapipe("auto", levels));
    EXPECT_NEAR(renderer.render(lit_job(1, Strategy::lights)).image.at(0, 0, 0), expected, 1e-6) << levels;
  }
}

}  // namespace
}  // namespace capcon
