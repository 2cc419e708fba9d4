// Direct lighting by environments and by many lights at once, and lights that the camera sees.
#include "render/lit_scenes.h"

namespace capcon {
namespace {

using namespace testing;

std::string map_light(const std::string& name, const std::string& kind = "mapname",
                      const std::string& factor = "1") {
  return within("Rotate 50 1 2 3 LightSource \"infinite\" \"rgb L\" [1 .9 .8] \"float scale\" " + factor +
                " \"string " + kind + "\" \"" + name + "\"");
}

std::vector<SceneImage> maps() {
  Image grey(9, 5, 1);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) grey.pixels[i] = 0.2f * static_cast<float>(i % 7);
  Image lamps(33, 15, 3);  // nearly everything is black
  for (const auto& [x, y] : {std::pair{4, 3}, {4, 4}, {20, 7}, {32, 14}, {0, 0}}) lamps.at(x, y, y % 3) = 40;
  return {{"even", random_image(24, 12, 1)},
          {"odd", random_image(17, 7, 2)},
          {"stiff", random_image(64, 33, 3, 20000)},
          {"square", random_image(16, 16, 4)},
          {"odd square", random_image(15, 15, 5)},
          {"stiff square", random_image(32, 32, 6, 20000)},
          {"grey", grey},
          {"lamps", lamps},
          {"texel", random_image(1, 1, 7)},
          {"column", random_image(1, 6, 8)},
          {"row", random_image(5, 1, 9)}};
}

const std::string kLatLong = map_light("even") + map_light("odd") + map_light("stiff", "mapname", ".01") +
                             map_light("grey") + map_light("lamps") + map_light("texel") +
                             map_light("column") + map_light("row");

TEST(DirectEnvironments, LatLongMapsAgreeWithTheReference) {
  Scene scene = look_at_patches(ground() + kLatLong, 32, 24, 30);  // between the patches the maps are seen
  put_images(scene, maps());
  expect_agreement("lat-long", scene, lit_job());
}

TEST(DirectEnvironments, MapsOfAllKindsAtOnceWithOtherLights) {
  const std::string all =
      map_light("square", "filename") + "LightSource \"distant\" \"rgb L\" [.3 .2 .1]\n" +
      map_light("stiff square", "filename", ".01") + "LightSource \"infinite\" \"rgb L\" [.1 .2 .3]\n" +
      within("Rotate 90 0 1 0 " + map_light("odd square", "filename")) +
      lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" ") + map_light("stiff", "mapname", ".01");
  Scene scene = look_at_patches(ground() + all, 32, 24, 30);
  put_images(scene, maps());
  Renderer renderer(scene, lavapipe());
  const Reference reference(scene);
  for (const Strategy s : {Strategy::power, Strategy::bsdf})
    expect_agreement("all", renderer, reference, lit_job(4, s));
}

/// Thirty lights of every kind.
std::string many_lights(bool meshes) {
  std::string text;
  const std::string shapes[] = {
      "Shape \"disk\" \"float innerradius\" .3 ", "Shape \"sphere\" ",
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 .2 -1 1 .2] \"integer indices\" [0 1 2 0 2 "
      "3] ",
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 0 1 .3] \"integer indices\" [0 1 2] "};
  for (int i = 0; i < 30; ++i) {
    const auto random = [&](int k) { return std::to_string(2 * uniform64(11, i, k) - 1); };
    const std::string place = "Translate " + random(0) + " " + random(1) + " " +
                              std::to_string(0.6 + 0.05 * i) + " Rotate 160 " + random(2) + " " + random(3) +
                              " 0 Scale .2 .2 .2 ";
    text += lamp((i % 3 ? "" : "ReverseOrientation ") + place + shapes[i % (meshes ? 4 : 3)],
                 i % 2 ? "\"bool twosided\" true " : "");
  }
  return text;
}

// With mesh lights a ray of the BSDF looks for the nearest surface, without for the nearest light.
TEST(DirectLights, ManyAgreeWithTheReferenceAndAreSeen) {
  for (const bool meshes : {false, true}) {
    const Scene scene = look_at_patches(ground() + many_lights(meshes));
    expect_agreement(meshes ? "with meshes" : "without", scene, lit_job(2), 1e-4, 3);
    Scene level = scene;
    level.camera = test::camera_at({0, -4, 1.4}, {0, 1, 0}, 50);
    level.film = {32, 32, ""};
    expect_agreement("seen", level, lit_job(1, Strategy::bsdf), 1e-4, 8);  // silhouettes
  }
}

}  // namespace
}  // namespace capcon
