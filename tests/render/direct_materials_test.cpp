// Direct lighting on the device against the reference, material by material.
#include "render/lit_scenes.h"

namespace capcon {
namespace {

using namespace testing;

const std::string kLamp = lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8"),
                  kSky = "LightSource \"infinite\" \"rgb L\" [.3 .4 .6]\n";

std::string textured(const char* wrap, const char* more = "") {
  return std::string("Texture \"") + wrap +
         "\" \"spectrum\" \"imagemap\" \"string filename\" \"picture\" \"string wrap\" \"" + wrap + "\" " +
         more + "\nMaterial \"diffuse\" \"texture reflectance\" \"" + wrap + "\"\n";
}

/// A glossy table of the test's own, as a MERL binary.
std::string glossy_table(const test::Folder& folder) {
  constexpr int kSize[3] = {24, 8, 16};
  std::string bytes(12 + 24 * std::size_t(kSize[0]) * kSize[1] * kSize[2], '\0');
  std::memcpy(bytes.data(), kSize, 12);
  std::size_t at = 12;
  for (int c = 0; c < 3; ++c) {
    for (int h = 0; h < kSize[0]; ++h) {
      for (int d = 0; d < kSize[1]; ++d) {
        for (int a = 0; a < kSize[2]; ++a, at += 8) {
          const double value =
              1500 * (0.1 + 0.02 * c + 0.01 * d + 0.01 * std::abs(a - 8) + 3 * std::exp(-0.3 * h));
          std::memcpy(bytes.data() + at, &value, 8);
        }
      }
    }
  }
  return folder.write("glossy.binary", bytes);
}

std::string plastic(const char* type, const char* roughness) {
  return std::string("Material \"") + type +
         "\" \"rgb Kd\" [.5 .4 .2] \"rgb reflectance\" [.5 .4 .2] \"rgb Ks\" [.3 .4 .5] " + roughness;
}

const std::string kRough = "\"float roughness\" 1 \"bool remaproughness\" false ",
                  kSharp = "\"float roughness\" .001 \"bool remaproughness\" false ",
                  kGloss = "\"float roughness\" .1 \"bool remaproughness\" false ";

std::vector<std::string> all_materials(const test::Folder& folder) {
  return {
      matte(0.7),
      textured("repeat", "\"float uscale\" 2.3 \"float vdelta\" .4"),
      textured("black", "\"bool invert\" true"),
      textured("clamp", "\"float scale\" .6"),
      "Material \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" \"spectrum k\" \"metal-Cu-k\" " + kGloss,
      "Material \"conductor\" " + kRough,
      plastic("plastic", kGloss.c_str()),
      plastic("plastic", kRough.c_str()),
      plastic("substrate", "\"float uroughness\" .1 \"float vroughness\" .1 \"bool remaproughness\" false "),
      plastic("coateddiffuse", kGloss.c_str()),
      "Material \"measured\" \"string filename\" \"" + glossy_table(folder) + "\"\n",
      matte(0),
      "Material \"plastic\" \"texture Kd\" \"repeat\" \"rgb Ks\" [.5 .5 .5] " + kGloss,
      plastic("coateddiffuse", kRough.c_str()),
      plastic("substrate", "\"float uroughness\" 1 \"float vroughness\" 1 \"bool remaproughness\" false "),
      "Material \"plastic\" \"rgb Kd\" [0 0 0] \"rgb Ks\" [.5 .5 .5] " + kGloss};
}

TEST(DirectMaterials, AllAgreeWithTheReferenceByEveryStrategy) {
  const test::Folder folder;
  Scene scene = look_at_patches(kShades + patches(all_materials(folder), 4) + kLamp + kSky, 44, 36, 30);
  put_images(scene, {{"picture", random_image(7, 5, 1)}});
  Renderer renderer(scene, lavapipe("texel"));
  const Reference reference(scene);
  for (const Strategy s : {Strategy::power, Strategy::balance, Strategy::lights, Strategy::bsdf})
    expect_agreement("strategy " + std::to_string(int(s)), renderer, reference, lit_job(4, s), 1e-4, 2);
  Renderer storage(scene, lavapipe("storage"));
  EXPECT_EQ(renderer.render(lit_job()).image.pixels, storage.render(lit_job()).image.pixels);
}

// Of one kind alone: what the others need is compiled out.
TEST(DirectMaterials, EachAloneAgreesWithTheReference) {
  const test::Folder folder;
  const std::vector<std::string> all = all_materials(folder);
  for (const int m : {0, 8, 10}) {
    const Scene scene = look_at_patches(all[m] + "Shape \"disk\" \"float radius\" 9 " + kLamp, 16, 12);
    expect_agreement(all[m], scene, lit_job(8));
  }
}

// The sharpest gloss: half vectors of 1e-3 have few digits.
TEST(DirectMaterials, SharpGlossAgreesWithTheReference) {
  const std::vector<std::string> sharp = {
      "Material \"conductor\" " + kSharp, plastic("plastic", kSharp.c_str()),
      plastic("substrate",
              "\"float uroughness\" .001 \"float vroughness\" .001 \"bool remaproughness\" false "),
      plastic("coateddiffuse", kSharp.c_str())};
  const Scene scene = look_at_patches(patches(sharp, 2) + kLamp + kSky);
  expect_agreement("sharp", scene, lit_job(16), 2e-4, 2);
}

}  // namespace
}  // namespace capcon
