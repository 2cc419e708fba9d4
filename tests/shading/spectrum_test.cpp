#include "shading/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "shading/metals.h"

namespace capcon {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

TEST(Spectrum, MatchingFunctionsAreThoseOfTheStandard) {
  // CIE 1931 2-degree observer, table of the standard.
  expect_near(colour_matching(450), {0.3362, 0.0380, 1.7721}, 0.03);
  expect_near(colour_matching(500), {0.0049, 0.3230, 0.2720}, 0.03);
  expect_near(colour_matching(555), {0.5121, 1.0000, 0.0057}, 0.03);
  expect_near(colour_matching(600), {1.0622, 0.6310, 0.0008}, 0.03);
  expect_near(colour_matching(650), {0.2835, 0.1070, 0.0000}, 0.03);
}

TEST(Spectrum, LinearBetweenSamplesAndConstantBeyond) {
  const Spectrum spectrum{{400, 500, 700}, {1, 3, 2}};
  EXPECT_EQ(spectrum.at(300), 1);
  EXPECT_EQ(spectrum.at(450), 2);
  EXPECT_EQ(spectrum.at(600), 2.5);
  EXPECT_EQ(spectrum.at(900), 2);
  EXPECT_EQ((Spectrum{{500}, {7}}.at(400)), 7);
}

TEST(Spectrum, AConstantReflectanceStaysWhatItIs) {
  expect_near(rgb_of_reflectance({{400, 700}, {0.4, 0.4}}), glm::dvec3(0.4), 1e-12);
}

TEST(Spectrum, EqualEnergyLightHasUnitLuminanceAndTheColourOfE) {
  const glm::dvec3 rgb = rgb_of_emission({{400}, {1}});
  EXPECT_NEAR(luminance(rgb), 1, 1e-6);
  expect_near(rgb, {1.2048, 0.9483, 0.9089}, 0.01);  // illuminant E in linear sRGB
}

TEST(Spectrum, WeightsGiveTheReflectance) {
  const std::vector<double> wavelengths = {400, 450, 520, 600, 700};
  const Spectrum spectrum{wavelengths, {0.3, 0.2, 0.5, 0.9, 0.4}};
  const auto weights = reflectance_weights(wavelengths);
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < weights.size(); ++i) sum += spectrum.values[i] * weights[i];
  expect_near(sum, rgb_of_reflectance(spectrum), 1e-12);
}

TEST(Spectrum, BlackBodiesHaveTheirChromaticities) {
  // Planckian locus, Wyszecki and Stiles: 2856 K is illuminant A, x 0.4476 y 0.4074; 6500 K: 0.3135 0.3237.
  const auto chromaticity = [](const glm::dvec3& rgb) {
    const glm::dvec3 xyz(0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z,
                         0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z,
                         0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z);
    return xyz / (xyz.x + xyz.y + xyz.z);
  };
  const glm::dvec3 a = chromaticity(rgb_of_blackbody(2856)), day = chromaticity(rgb_of_blackbody(6500));
  EXPECT_NEAR(a.x, 0.4476, 0.004);
  EXPECT_NEAR(a.y, 0.4074, 0.004);
  EXPECT_NEAR(day.x, 0.3135, 0.004);
  EXPECT_NEAR(day.y, 0.3237, 0.004);
  EXPECT_NEAR(blackbody(2.897771955e6 / 5000, 5000), 1, 1e-12);
  EXPECT_LT(blackbody(540, 5000), 1);
}

TEST(Spectrum, Illuminants) {
  expect_near(*rgb_of_illuminant("stdillum-D65"), glm::dvec3(1), 1e-6);
  const glm::dvec3 d50 = *rgb_of_illuminant("stdillum-D50");
  EXPECT_NEAR(luminance(d50), 1, 1e-9);
  expect_near(d50, {1.179, 0.976, 0.728}, 0.02);  // x 0.3457 y 0.3585
  EXPECT_FALSE(rgb_of_illuminant("stdillum-F8"));
  EXPECT_FALSE(rgb_of_illuminant("D65"));
}

/// Reflectance at normal incidence, ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
glm::dvec3 mirror(const glm::dvec3& n, const glm::dvec3& k) {
  return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

// Johnson and Christy, "Optical Constants of the Noble Metals", Phys. Rev. B 6 (1972): eV, n, k.
struct Row {
  double ev, n, k;
};
constexpr Row kGold[] = {{1.64, .14, 4.542},  {1.76, .13, 4.103},  {1.88, .14, 3.697},  {2.01, .21, 3.272},
                         {2.14, .29, 2.863},  {2.26, .43, 2.455},  {2.38, .62, 2.081},  {2.50, 1.04, 1.833},
                         {2.63, 1.31, 1.849}, {2.75, 1.38, 1.914}, {2.88, 1.45, 1.948}, {3.00, 1.46, 1.958}};
constexpr Row kCopper[] = {{1.76, .21, 4.205},  {1.88, .22, 3.747},  {2.01, .30, 3.205},  {2.14, .70, 2.704},
                           {2.26, 1.02, 2.577}, {2.38, 1.18, 2.608}, {2.50, 1.22, 2.564}, {2.63, 1.25, 2.483},
                           {2.75, 1.24, 2.397}, {2.88, 1.25, 2.305}, {3.00, 1.28, 2.207}};

template <std::size_t n>
glm::dvec3 measured_mirror(const Row (&rows)[n]) {
  Spectrum spectrum;
  for (std::size_t i = n; i-- > 0;) {
    const Row& row = rows[i];
    spectrum.wavelengths.push_back(1239.84 / row.ev);
    spectrum.values.push_back(mirror(glm::dvec3(row.n), glm::dvec3(row.k)).x);
  }
  return rgb_of_reflectance(spectrum);
}

TEST(Metals, ReflectWhatTheLiteratureMeasured) {
  const auto of = [](const std::string& name) {
    return mirror(*named_metal_spectrum("metal-" + name + "-eta"),
                  *named_metal_spectrum("metal-" + name + "-k"));
  };
  expect_near(of("Au"), measured_mirror(kGold), 0.07);
  expect_near(of("Cu"), measured_mirror(kCopper), 0.07);
  expect_near(of("Al"), {0.912, 0.914, 0.920},
              0.03);  // Hoffman, "Background: Physics and Math of Shading", 2013
  expect_near(of("Ag"), {0.972, 0.960, 0.915}, 0.03);
}

TEST(Metals, NamesOfAllVersions) {
  EXPECT_EQ(named_metal_spectrum("spds/Cu.eta.spd"), named_metal_spectrum("metal-Cu-eta"));
  EXPECT_EQ(named_metal_spectrum("Cu.k.spd"), named_metal_spectrum("metal-Cu-k"));
  EXPECT_NE(named_metal_spectrum("metal-Cu-k"), named_metal_spectrum("metal-Cu-eta"));
  EXPECT_FALSE(named_metal_spectrum("metal-Xx-k"));
  EXPECT_FALSE(named_metal_spectrum("xCu.k.spd"));
  EXPECT_NEAR(*named_glass_index("glass-BK7"), 1.517, 1e-3);
}

}  // namespace
}  // namespace capcon
