// The invented lacquer is a BRDF: reciprocal, it reflects less than arrives, and its table says what its
// formula says.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/hash.h"
#include "generator/lacquer.h"
#include "shading/measured_brdf.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kPi = scenes::kPi;

scenes::Vec3 direction(double cosine, double phi) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}
scenes::Vec3 random_direction(std::uint64_t i, double least_cosine) {
  return direction(least_cosine + (1 - least_cosine) * uniform64(1, 9, 2 * i),
                   2 * kPi * uniform64(1, 9, 2 * i + 1));
}

TEST(Lacquer, IsReciprocalAndIsotropic) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const scenes::Vec3 a = random_direction(2 * i, 0.01), b = random_direction(2 * i + 1, 0.01);
    const double wavelength = 400 + 0.3 * static_cast<double>(i), value = scenes::lacquer(wavelength, a, b);
    ASSERT_GT(value, 0);
    EXPECT_NEAR(scenes::lacquer(wavelength, b, a) / value, 1, 1e-12);
    const scenes::Vec3 c(-a.y, a.x, a.z), d(-b.y, b.x, b.z);  // turned by a quarter
    EXPECT_NEAR(scenes::lacquer(wavelength, c, d) / value, 1, 1e-12);
  }
}

TEST(Lacquer, ReflectsLessThanArrivesAtEveryWavelength) {
  for (const double wavelength : {400.0, 450.0, 500.0, 540.0, 560.0, 600.0, 650.0, 700.0}) {
    for (const double cosine : {1.0, 0.87, 0.71, 0.5, 0.26, 0.09, 0.02}) {
      constexpr int kRings = 200, kTurns = 200;
      double albedo = 0;
      for (int r = 0; r < kRings; ++r) {
        const double z = (r + 0.5) / kRings;
        for (int t = 0; t < kTurns; ++t)
          albedo +=
              scenes::lacquer(wavelength, direction(cosine, 0), direction(z, 2 * kPi * (t + 0.5) / kTurns)) *
              z;
      }
      albedo *= 2 * kPi / (kRings * kTurns);
      EXPECT_LT(albedo, 1) << wavelength << " nm, cosine " << cosine;
      EXPECT_GT(albedo, 0.05) << wavelength << " nm, cosine " << cosine;
    }
  }
}

TEST(Lacquer, TableIsReadWithoutRemarkAndFollowsTheFormula) {
  const std::string text = scenes::lacquer_table();
  EXPECT_EQ(text, scenes::lacquer_table());
  const CornellBrdf table = parse_cornell_brdf(text, "lacquer");
  EXPECT_EQ(table.samples.size(), 19u + 25 * (18 * 19 / 2));
  EXPECT_EQ(table.negatives, 0u);
  for (const BrdfSample& sample : table.samples) EXPECT_LE(sample.theta_in, sample.theta_out);
  const MeasuredBrdf brdf = resample(table);
  EXPECT_TRUE(brdf.remarks.empty());
  for (const double cosine : {0.97, 0.87, 0.71, 0.5, 0.26, 0.17}) {
    const glm::dvec3 albedo = directional_albedo(brdf, cosine);
    for (int c = 0; c < 3; ++c) EXPECT_LT(albedo[c], 0.75) << cosine;
  }
  std::vector<double> wavelengths;
  for (int w = 0; w < 16; ++w) wavelengths.push_back(400 + 20 * w);
  const std::vector<glm::dvec3> weights = reflectance_weights(wavelengths);
  glm::dvec3 error(0), size(0);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const scenes::Vec3 a = random_direction(2 * i, 0.34), b = random_direction(2 * i + 1, 0.34);
    glm::dvec3 exact(0);
    for (int w = 0; w < 16; ++w) exact += scenes::lacquer(wavelengths[w], a, b) * weights[w];
    const glm::dvec3 off = brdf(a, b) - glm::max(exact, glm::dvec3(0));
    error += off * off;
    size += exact * exact;
  }
  for (int c = 0; c < 3; ++c) EXPECT_LT(std::sqrt(error[c] / size[c]), 0.12) << c;
}

}  // namespace
}  // namespace capcon
