#include "shading/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene_text.h"
#include "shading/roughness.h"

namespace capcon {
namespace {

using test::error_of;
using test::parse_world;
using testing::ElementsAre;

Materials materials_of(const std::string& text) {
  return read_materials(parse_world(text));
}

/// The first material of a text that gives rise to no warning.
Material clean(const std::string& text) {
  const Materials materials = materials_of(text);
  EXPECT_THAT(materials.warnings, ElementsAre());
  return materials.values.at(0);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

TEST(Material, DiffuseOfBothNames) {
  for (const char* text :
       {"Material \"matte\" \"color Kd\" [.1 .2 .3]", "Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]",
        "MakeNamedMaterial \"x\" \"string type\" \"diffuse\" \"rgb reflectance\" [.1 .2 .3]"}) {
    const Material material = clean(text);
    EXPECT_EQ(material.kind, MaterialKind::diffuse);
    EXPECT_EQ(material.reflectance, glm::dvec3(0.1, 0.2, 0.3));
  }
  EXPECT_EQ(clean("Material \"matte\"").reflectance, glm::dvec3(0.5));
  expect_near(clean("Material \"diffuse\" \"spectrum reflectance\" [400 .3 700 .3]").reflectance,
              glm::dvec3(0.3));
  EXPECT_EQ(clean("Material \"diffuse\" \"float reflectance\" .25").reflectance, glm::dvec3(0.25));
}

TEST(Material, TheDefaultStandsBehindTheOthers) {
  const Materials materials = materials_of("Material \"matte\" \"color Kd\" [0 0 0]");
  ASSERT_EQ(materials.values.size(), 2u);
  EXPECT_EQ(materials.of(-1).reflectance, glm::dvec3(0.5));
  EXPECT_EQ(materials.of(0).reflectance, glm::dvec3(0));
  EXPECT_EQ(read_materials(Scene{}).of(-1), Material{});
}

TEST(Material, OldPlastic) {
  const Material material =
      clean("Material \"plastic\" \"color Kd\" [.5 .25 .15] \"color Ks\" [.3 .3 .3] \"float roughness\" .05");
  EXPECT_EQ(material.kind, MaterialKind::plastic);
  EXPECT_EQ(material.coat, Coat::added);
  EXPECT_EQ(material.reflectance, glm::dvec3(0.5, 0.25, 0.15));
  EXPECT_EQ(material.specular, glm::dvec3(0.3));
  EXPECT_EQ(material.eta, glm::dvec3(1.5));
  EXPECT_NEAR(material.alpha, std::sqrt(2.0 / 22), 1e-12);  // Blinn exponent 20
}

TEST(Material, SubstrateReflectsKsAtNormalIncidence) {
  const Material material = clean(
      "Material \"substrate\" \"color Ks\" [.2 .1 .04] \"float uroughness\" .08 \"float vroughness\" .08");
  EXPECT_EQ(material.kind, MaterialKind::plastic);
  EXPECT_EQ(material.coat, Coat::substrate);
  EXPECT_EQ(material.specular, glm::dvec3(0.2, 0.1, 0.04));
  EXPECT_EQ(material.reflectance, glm::dvec3(0.5));
  EXPECT_NEAR(material.alpha, alpha_of_v2(0.08), 1e-12);
}

TEST(Material, Metals) {
  const Material old = clean(
      "Material \"metal\" \"color eta\" [.143 .375 1.442] \"color k\" [3.983 2.386 1.603] \"float "
      "roughness\" .05");
  EXPECT_EQ(old.kind, MaterialKind::conductor);
  EXPECT_EQ(old.eta, glm::dvec3(0.143, 0.375, 1.442));
  EXPECT_EQ(old.k, glm::dvec3(3.983, 2.386, 1.603));
  const Material gold = clean(
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" \"float "
      "roughness\" .09");
  EXPECT_EQ(gold.eta, old.eta);
  EXPECT_EQ(gold.k, old.k);
  EXPECT_NEAR(gold.alpha, 0.3, 1e-12);
  EXPECT_NEAR(clean("Material \"conductor\" \"float roughness\" .09 \"bool remaproughness\" false").alpha,
              0.09, 1e-12);
  const Material copper = clean("Material \"metal\"");
  EXPECT_EQ(copper.eta,
            (clean("Material \"metal\" \"spectrum eta\" \"spds/Cu.eta.spd\" \"spectrum k\" \"spds/Cu.k.spd\"")
                 .eta));
  const Material grey = clean("Material \"conductor\" \"rgb reflectance\" [.2 .5 .8]");
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(fresnel(1, grey.eta[c], grey.k[c]), (glm::dvec3(0.2, 0.5, 0.8)[c]), 1e-9);
}

TEST(Material, CoatedDiffuse) {
  const Material material = clean(
      "Material \"coateddiffuse\" \"rgb reflectance\" [.1 .2 .3] \"float roughness\" .04 \"float eta\" 1.4");
  EXPECT_EQ(material.kind, MaterialKind::plastic);
  EXPECT_EQ(material.coat, Coat::transmitted);
  EXPECT_EQ(material.eta, glm::dvec3(1.4));
  EXPECT_NEAR(material.alpha, 0.2, 1e-12);
  EXPECT_EQ(clean("Material \"coateddiffuse\"").alpha, kSmallestAlpha);
}

TEST(Material, RoughnessOfTheVersions) {
  EXPECT_NEAR(alpha_of_v3(1), 1, 1e-12);  // 1.62142, bounded
  EXPECT_NEAR(alpha_of_v3(0.1), 0.4617, 1e-3);
  EXPECT_NEAR(alpha_of_v2(0.1), std::sqrt(0.2 / 1.2), 1e-12);
  for (double r = 0.001; r <= 0.1; r += 0.001) EXPECT_NEAR(alpha_of_v2(r), alpha_of_v3(r), 0.06) << r;
  EXPECT_EQ(alpha_of_v2(0), kSmallestAlpha);
  EXPECT_EQ(alpha_of_v4(0), kSmallestAlpha);
  const Materials v3 = materials_of(
      "Material \"metal\" \"float roughness\" .1\nMaterial \"metal\" \"float roughness\" .1 \"bool "
      "remaproughness\" \"false\"");
  EXPECT_NEAR(v3.values[0].alpha, alpha_of_v3(0.1), 1e-12);  // the other one shows the version
  EXPECT_NEAR(v3.values[1].alpha, 0.1, 1e-12);
}

TEST(Material, WhatIsApproximatedIsSaidOnceAMaterial) {
  const Materials materials = materials_of(
      "MakeNamedMaterial \"pane\" \"string type\" \"glass\" \"float index\" 1.4\n"
      "Material \"uber\" \"rgb Kt\" [.1 0 0] \"rgb opacity\" [.5 .5 .5]\n"
      "Material \"mattte\"\n"
      "Material \"matte\" \"float sigma\" 20 \"rgb Kd\" [2 0 0]\n"
      "Material \"metal\" \"float uroughness\" .04 \"float vroughness\" .01\n"
      "Material \"mirror\"");
  EXPECT_THAT(
      materials.warnings,
      ElementsAre(
          "s.pbrt:2:1: the material \"pane\" (glass): what it transmits is left out: it is a black plastic",
          "s.pbrt:3:1: the material (uber): what it transmits is left out; it is opaque",
          "s.pbrt:4:1: the material (mattte): there is no such material, the default is used; did "
          "you mean \"matte\"?",
          "s.pbrt:5:1: the material (matte): its sigma is left out: it is Lambertian; \"Kd\" is "
          "bounded by 1",
          "s.pbrt:6:1: the material (metal): it is equally rough in all directions",
          "s.pbrt:7:1: the material (mirror): it is a metal of GGX alpha 0.001"));
  EXPECT_EQ(materials.values[0].kind, MaterialKind::plastic);
  EXPECT_EQ(materials.values[0].eta, glm::dvec3(1.4));
  EXPECT_EQ(materials.values[0].reflectance, glm::dvec3(0));
  EXPECT_EQ(materials.values[3].reflectance, glm::dvec3(1, 0, 0));
  EXPECT_NEAR(materials.values[4].alpha, alpha_of_v2(0.02), 1e-12);
  for (const double cosine : {0.0, 0.3, 1.0})
    EXPECT_NEAR(fresnel(cosine, materials.values[5].eta.x, materials.values[5].k.x), 1, 1e-12);
}

TEST(Material, EveryNameOfPbrtIsRead) {
  for (const char* type : {"matte",
                           "plastic",
                           "translucent",
                           "glass",
                           "mirror",
                           "metal",
                           "substrate",
                           "uber",
                           "shinymetal",
                           "subsurface",
                           "kdsubsurface",
                           "disney",
                           "hair",
                           "fourier",
                           "diffuse",
                           "coateddiffuse",
                           "coatedconductor",
                           "diffusetransmission",
                           "dielectric",
                           "thindielectric",
                           "conductor",
                           "interface",
                           "none",
                           ""}) {
    const Materials materials = materials_of(std::string("Material \"") + type + "\"");
    for (const std::string& warning : materials.warnings)
      EXPECT_EQ(warning.find("no such material"), std::string::npos) << warning;
    const Material& material = materials.values[0];
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(material.reflectance[c] >= 0 && material.reflectance[c] <= 1) << type;
      EXPECT_TRUE(material.specular[c] >= 0 && material.specular[c] <= 1) << type;
      EXPECT_TRUE(std::isfinite(material.eta[c]) && std::isfinite(material.k[c])) << type;
    }
    EXPECT_TRUE(material.alpha >= kSmallestAlpha && material.alpha <= 1) << type;
  }
}

TEST(Material, MixesTakeTheirLargerPart) {
  const std::string parts =
      "MakeNamedMaterial \"a\" \"string type\" \"matte\" \"rgb Kd\" [1 0 0] MakeNamedMaterial \"b\" \"string "
      "type\" "
      "\"matte\" \"rgb Kd\" [0 1 0] ";
  const auto red = [&](const std::string& mix) {
    return materials_of(parts + mix).values.at(2).reflectance.r;
  };
  EXPECT_EQ(red("Material \"mix\" \"string namedmaterial1\" \"a\" \"string namedmaterial2\" \"b\" \"float "
                "amount\" .7"),
            1);
  EXPECT_EQ(red("Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .7"), 0);
  EXPECT_EQ(error_of([&] {
              red("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"m\" \"m\"]");
            }),
            "s.pbrt:2:123: this mix holds itself");
}

TEST(Material, TexturesBecomeIndices) {
  Scene scene = parse_world(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.exr\"\n"
      "Texture \"r\" \"float\" \"imagemap\" \"string filename\" \"a.exr\"\n"
      "Material \"matte\" \"texture Kd\" \"t\"\nMaterial \"plastic\" \"texture Ks\" \"t\" \"texture "
      "roughness\" \"r\"");
  Image image(1, 2, 3);
  image.pixels = {0.1f, 0.2f, 0.3f, 0.3f, 0.4f, 0.5f};
  scene.images.push_back({"a.exr", image});
  EXPECT_EQ(read_materials(scene).values[0].reflectance, glm::dvec3(0.5));  // image not found: the default
  scene.textures[0].image = scene.textures[1].image = 0;
  const Materials materials = read_materials(scene);
  EXPECT_EQ(materials.values[0].texture, 0);
  expect_near(materials.values[0].reflectance, {0.2, 0.3, 0.4}, 1e-7);
  EXPECT_EQ(materials.values[1].texture, -1);
  expect_near(materials.values[1].specular, {0.2, 0.3, 0.4}, 1e-7);
  EXPECT_NEAR(materials.values[1].alpha, alpha_of_v2(0.3), 1e-7);
  ASSERT_EQ(materials.warnings.size(), 1u);
  EXPECT_NE(materials.warnings[0].find(
                "the texture of \"Ks\" is its mean; the texture of \"roughness\" is its mean"),
            std::string::npos);
}

TEST(Material, MeasuredFilesAreReadOnce) {
  const test::Folder folder;
  folder.write("b.brdf", "1\n500\n.1 0 .1 0 .2\n.2 0 .9 1 .2\n.2 0 .9 3 .2");
  const std::string path = folder.write("sub/in.pbrt", "");
  const Scene scene = parse_pbrt(
      "WorldBegin Material \"measured\" \"string filename\" \"../b.brdf\" Material \"measured\" \"string "
      "filename\" "
      "\"../b.brdf\" Material \"measured\" \"string filename\" \"no.brdf\"",
      path, {});
  const Materials materials = read_materials(scene);
  EXPECT_EQ(materials.measured.size(), 1u);
  EXPECT_EQ(materials.values[1].kind, MaterialKind::measured);
  EXPECT_EQ(materials.values[1].measured, 0);
  EXPECT_EQ(materials.values[2].kind, MaterialKind::diffuse);
  ASSERT_EQ(materials.warnings.size(), 1u);
  EXPECT_NE(materials.warnings[0].find("the BRDF \"no.brdf\" cannot be found, and it is grey"),
            std::string::npos);
}

TEST(Material, MistakesHaveTheirPlace) {
  const auto error = [](const std::string& text) { return error_of([&] { materials_of(text); }); };
  EXPECT_EQ(error("Material \"matte\" \"color Kd\" [1 2 3 4 5 6]"),
            "s.pbrt:2:18: \"color Kd\" must be one number or three");
  EXPECT_EQ(error("Material \"matte\" \"string Kd\" \"x\""), "s.pbrt:2:18: \"string Kd\" must be a colour");
  EXPECT_EQ(error("Material \"plastic\" \"float roughness\" -1"),
            "s.pbrt:2:20: \"roughness\" must be 0 or more");
  EXPECT_EQ(error("Material \"matte\" \"texture Kd\" \"t\""), "s.pbrt:2:18: there is no texture named \"t\"");
  EXPECT_EQ(error("Material \"metal\" \"spectrum eta\" \"metal-Xy-eta\"").substr(0, 30),
            "s.pbrt:2:18: \"spectrum eta\" na");
  EXPECT_EQ(error("Material \"matte\" \"spectrum Kd\" [400 1 300 1]"),
            "s.pbrt:2:18: the wavelengths of \"spectrum Kd\" must rise; 300 follows 400");
  EXPECT_EQ(error("Material \"matte\" \"spectrum Kd\" [400]"),
            "s.pbrt:2:18: \"spectrum Kd\" must hold pairs of a wavelength and a value");
  EXPECT_EQ(error("Material \"matte\" \"float Kd\" 1e31"), "s.pbrt:2:18: \"float Kd\" is too large");
  EXPECT_EQ(error("Material \"measured\""), "s.pbrt:2:1: a measured material needs its \"string filename\"");
}

TEST(Material, FresnelHasItsKnownValues) {
  EXPECT_NEAR(fresnel(1, 1.5, 0), 0.04, 1e-12);
  // 60 degrees on glass: r_s = -0.4202, r_p = 0.0425 (Snell by hand).
  const double c = 0.5, t = std::sqrt(1 - 0.75 / 2.25);
  const double rs = (c - 1.5 * t) / (c + 1.5 * t), rp = (1.5 * c - t) / (1.5 * c + t);
  EXPECT_NEAR(fresnel(c, 1.5, 0), (rs * rs + rp * rp) / 2, 1e-12);
  EXPECT_NEAR(fresnel(1, 0.2, 3.9), (0.64 + 15.21) / (1.44 + 15.21), 1e-12);
  for (const double k : {0.0, 2.0}) EXPECT_NEAR(fresnel(0, 1.3, k), 1, 1e-12);
  // Walsh's closed form for 1.5: the mean outer reflectance is 0.0918, the inner one 0.5963.
  EXPECT_NEAR(inner_reflectance(1.5), 0.5963, 2e-4);
  EXPECT_NEAR(inner_reflectance(1), 0, 1e-9);
}

/// A white base under a smooth coat reflects all light, whatever its angle: Coat::transmitted loses none.
TEST(Material, TransmittedCoatsPassTheFurnace) {
  for (const double eta : {1.2, 1.5, 2.0}) {
    double leaves = 0;  // cosine-weighted mean of 1 - F
    const int steps = 2000;
    for (int i = 0; i < steps; ++i) leaves += (1 - fresnel(std::sqrt((i + 0.5) / steps), eta, 0)) / steps;
    for (const double cosine : {0.1, 0.5, 1.0}) {
      const double coat = fresnel(cosine, eta, 0);
      EXPECT_NEAR(coat + (1 - coat) * leaves / (eta * eta * (1 - inner_reflectance(eta))), 1, 1e-4);
    }
  }
}

}  // namespace
}  // namespace capcon
