// All strategies estimate the same: what light samples find and what BSDF samples find.
#include <gtest/gtest.h>

#include "reference/lighting.h"

namespace capcon {
namespace {

using test::Estimate;
using test::kFloor;
using test::lamp;
using test::matte;

const std::string kRough = "\"float roughness\" .1 ";
const std::string kGrey = " [.5 .5 .5] ";

struct Named {
  const char* name;
  std::string text;
};

const std::vector<Named> kMaterials = {
    {"diffuse", matte(0.7)},
    {"conductor",
     "Material \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" \"spectrum k\" \"metal-Cu-k\" " + kRough},
    {"plastic", "Material \"plastic\" \"rgb Kd\"" + kGrey + "\"rgb Ks\"" + kGrey + kRough},
    {"substrate", "Material \"substrate\" \"rgb Kd\"" + kGrey + "\"rgb Ks\"" + kGrey +
                      "\"float uroughness\" .1 \"float vroughness\" .1 "},
    {"coateddiffuse", "Material \"coateddiffuse\" \"rgb reflectance\"" + kGrey + kRough},
};

/// Seen from the origin towards about (-0.7, 0.4, 0.8), the mirror direction of the viewer.
const std::vector<Named> kLights = {
    {"disk", lamp("Translate -.7 .4 .8 Rotate 130 1 0 0 Shape \"disk\" \"float radius\" .5",
                  "\"bool twosided\" true ")},
    {"ring",
     lamp("ReverseOrientation Translate -.7 .4 1 Scale 1 2 1 Shape \"disk\" \"float innerradius\" .5")},
    {"sphere", lamp("Translate -1 .5 1 Shape \"sphere\" \"float radius\" .7")},
    {"sunken sphere", lamp("Translate -2 1 .3 Shape \"sphere\" \"float radius\" .9")},
    {"sphere about it", lamp("ReverseOrientation Translate 0 .3 .4 Shape \"sphere\" \"float radius\" 2")},
    {"ellipsoid", lamp("Translate -1 .5 1 Rotate 30 1 1 0 Scale .3 1 .6 Shape \"sphere\"")},
    {"two-sided ellipsoid",
     lamp("ReverseOrientation Translate -1 .5 1 Rotate 30 1 1 0 Scale .3 1 .6 Shape \"sphere\"",
          "\"bool twosided\" true ")},
    {"rectangle", lamp("Shape \"trianglemesh\" \"point3 P\" [-1 -1 1 -1 1 1 1 1 2 1 -1 2] \"integer "
                       "indices\" [0 1 2 0 2 3]")},
    {"mesh that hides itself", lamp("Translate -1 .5 1 Scale .5 .4 .3 Shape \"trianglemesh\" \"point3 P\" "
                                    "[-1 -1 -1 1 -1 -1 0 1 -1 0 0 1] "
                                    "\"integer indices\" [0 1 2 0 1 3 1 2 3 2 0 3]",
                                    "\"bool twosided\" true ")},
    {"constant environment", "LightSource \"infinite\" \"rgb L\" [1 1 1]\n"},
    {"environment map", "LightSource \"infinite\" \"string mapname\" \"map\"\n"},
    {"three behind a screen", lamp("ReverseOrientation Translate -.7 .4 1 Shape \"disk\"") +
                                  lamp("Translate 1 1 1 Shape \"sphere\" \"float radius\" .6") +
                                  "LightSource \"infinite\" \"rgb L\" [1 1 1]\nTranslate -.5 .2 .5 Shape "
                                  "\"disk\" \"float radius\" .3 "},
};

Scene scene_of(const std::string& material, const std::string& light) {
  Scene scene = test::look_at_origin(material + kFloor + light, 8);
  Image map(16, 8, 3);
  for (float& v : map.pixels) v = 0.2f;
  for (int c = 0; c < 3; ++c) map.at(8, 1, c) = 60;
  scene.images.push_back({"map", map});
  for (Entity& entity : scene.lights) entity.image = entity.parameters.entries.contains("mapname") ? 0 : -1;
  return scene;
}

void PrintTo(const Named& named, std::ostream* out) {
  *out << named.name;
}

class Strategies : public testing::TestWithParam<Named> {};

TEST_P(Strategies, Agree) {
  for (const Named& material : kMaterials) {
    const Scene scene = scene_of(material.text, GetParam().text);
    const Reference reference(scene);
    Estimate all[4];
    for (const Strategy s : {Strategy::lights, Strategy::bsdf, Strategy::power, Strategy::balance})
      all[int(s)] = test::estimate(reference.render(test::direct_job(512, s)).image);
    const Estimate power = all[int(Strategy::power)];
    EXPECT_GT(power.mean, 0.01) << material.name;
    for (const Estimate& e : all) {
      EXPECT_LT(std::abs(e.mean - power.mean), 4.5 * std::hypot(e.error, power.error) + 1e-6 * power.mean)
          << material.name;
      EXPECT_LT(e.error, 0.03 * e.mean) << material.name;  // or the test would say nothing
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, Strategies, testing::ValuesIn(kLights), [](const auto& info) {
  std::string name = info.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(c); });
  return name;
});

}  // namespace
}  // namespace capcon
