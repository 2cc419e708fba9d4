#include "shading/measured_brdf.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>

#include "base/hash.h"
#include "scene/scene_text.h"
#include "shading/microfacet.h"

namespace capcon {
namespace {

using test::error_of;
constexpr double kPi = 3.14159265358979323846;

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A direction on the upper hemisphere, at most 80 degrees from the normal.
glm::dvec3 random_direction(std::uint64_t stream, std::uint64_t counter) {
  const double z = 1 - uniform64(stream, 0, counter) * (1 - std::cos(80 * kPi / 180));
  return direction(std::acos(z), 2 * kPi * uniform64(stream, 1, counter));
}

std::string merl_bytes(int h, int d, int a, const std::function<double(int, int, int, int)>& value) {
  std::string bytes(12 + std::size_t(h) * d * a * 24, '\0');
  const int sizes[3] = {h, d, a};
  std::memcpy(bytes.data(), sizes, 12);
  constexpr double kScale[3] = {1500, 1500 / 1.15, 1500 / 1.66};
  std::size_t at = 12;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < h; ++i) {
      for (int j = 0; j < d; ++j) {
        for (int k = 0; k < a; ++k, at += 8) {
          const double scaled = value(c, i, j, k) * kScale[c];
          std::memcpy(bytes.data() + at, &scaled, 8);
        }
      }
    }
  }
  return bytes;
}

/// A glossy BRDF in closed form: Lambert and GGX with D G G / (4 cos cos), in half-difference angles.
double glossy(const glm::dvec3& in, const glm::dvec3& out, double alpha) {
  const glm::dvec3 half = glm::normalize(in + out);
  return 0.2 / kPi +
         0.5 * ggx(half.z, alpha) * ggx_masking(in.z, alpha) * ggx_masking(out.z, alpha) / (4 * in.z * out.z);
}

/// The same as a MERL table: values at the middles of the bins, nothing where a direction is below the
/// horizon.
MerlBrdf glossy_table(double alpha) {
  const auto value = [&](int, int h, int d, int a) {
    const double th = std::pow((h + 0.5) / 90, 2) * kPi / 2, td = (d + 0.5) / 90 * kPi / 2,
                 pd = (a + 0.5) / 180 * kPi;
    const glm::dvec3 n = direction(th, 0), t(std::cos(th), 0, -std::sin(th)), b(0, 1, 0);
    const glm::dvec3 side = std::sin(td) * (std::cos(pd) * t + std::sin(pd) * b);
    const glm::dvec3 in = std::cos(td) * n + side, out = std::cos(td) * n - side;
    return in.z > 1e-3 && out.z > 1e-3 ? glossy(in, out, alpha) : -1.0;
  };
  return parse_merl_brdf(merl_bytes(90, 90, 180, value), "m");
}

/// Rows over half a turn from `first` degrees.
std::string cornell_text(const std::function<double(double, double, double)>& value, int first = 0) {
  std::string text = "# a comment\n2\n400 700  # nm\n\n";
  for (int i = 5; i < 90; i += 10) {
    for (int o = 5; o < 90; o += 10) {
      for (int p = first; p <= first + 180; p += 15) {
        const double ti = i * kPi / 180, to = o * kPi / 180, phi = p * kPi / 180;
        const double f = value(ti, to, phi);
        text += fmt::format("{:.9f} 0 {:.9f} {:.9f} {:.9g} {:.9g}\n", ti, to, phi, f, f);
      }
    }
  }
  return text;
}

TEST(Measured, LambertianTablesOfBothFormats) {
  const MeasuredBrdf cornell =
      resample(parse_cornell_brdf(cornell_text([](double, double, double) { return 0.6 / kPi; }), "c"));
  const MeasuredBrdf merl = resample(
      parse_merl_brdf(merl_bytes(6, 5, 8, [](int c, int, int, int) { return (c + 1) * 0.2 / kPi; }), "m"));
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 in = random_direction(1, i), out = random_direction(2, i);
    EXPECT_NEAR(cornell(in, out).g * kPi, 0.6, 1e-6);
    EXPECT_NEAR(merl(in, out).b * kPi, 0.6, 1e-6);
    EXPECT_NEAR(merl(in, out).r * kPi, 0.2, 1e-6);
  }
  EXPECT_EQ(cornell(direction(0.3, 0), direction(2, 0)), glm::dvec3(0));
  for (const double cosine : {0.2, 0.5, 1.0}) EXPECT_NEAR(directional_albedo(cornell, cosine).r, 0.6, 0.006);
  EXPECT_TRUE(cornell.remarks.empty());
}

TEST(Measured, ReciprocalToTheLastDigits) {
  // Chirality, and a side that is brighter than the other: the table keeps neither.
  const MeasuredBrdf brdf = resample(parse_merl_brdf(
      merl_bytes(9, 9, 18, [](int, int h, int d, int a) { return 0.1 + h + 0.3 * d + (a < 5 ? a : 0); }),
      "m"));
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 in = random_direction(3, i), out = random_direction(4, i);
    EXPECT_NEAR(brdf(in, out).g, brdf(out, in).g, 1e-9 * brdf(in, out).g);
    const glm::dvec3 mirrored_in(in.x, -in.y, in.z), mirrored_out(out.x, -out.y, out.z);
    EXPECT_NEAR(brdf(in, out).g, brdf(mirrored_in, mirrored_out).g, 1e-9 * brdf(in, out).g);
  }
}

TEST(Measured, SidesThatDifferAreAveraged) {
  // Values by phi_d alone: 1 below pi/2 and 3 above; the table folds one onto the other.
  const MeasuredBrdf brdf = resample(
      parse_merl_brdf(merl_bytes(9, 9, 18, [](int, int, int, int a) { return a < 9 ? 1 : 3; }), "m"));
  EXPECT_NEAR(brdf(direction(0.5, 0), direction(0.7, 1)).g, 2, 1e-5);
}

TEST(Measured, TurnsOfTheTextAreFolded) {
  const MeasuredBrdf brdf = resample(parse_cornell_brdf(
      cornell_text([](double, double, double phi) { return 1 + std::cos(phi); }, 180), "c"));
  for (const double phi : {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75}) {
    for (const double start : {-3.0, 0.0, 2.0}) {
      const double value = brdf(direction(0.6, start), direction(0.8, start + phi * kPi)).g;
      EXPECT_NEAR(value, 1 + std::cos(phi * kPi), 0.12) << phi;
    }
  }
}

TEST(Measured, TableIsNearTheClosedForm) {
  for (const double alpha : {0.1, 0.3}) {
    const MeasuredBrdf brdf = resample(glossy_table(alpha));
    double error = 0, sum = 0, worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec3 in = random_direction(5, i), out = random_direction(6, i);
      const double truth = glossy(in, out, alpha), table = brdf(in, out).g;
      error += std::pow(table - truth, 2);
      sum += truth * truth;
      worst = std::max(worst, std::abs(table / truth - 1));
    }
    EXPECT_LT(std::sqrt(error / sum), 0.02) << alpha;
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LT(worst, 0.25) << alpha;
  }
}

TEST(Measured, FitFindsTheAlphaOfGgx) {
  for (const double alpha : {0.05, 0.2}) {
    MeasuredBrdf brdf = resample(glossy_table(alpha));
    fit_sampling(brdf);
    EXPECT_GT(brdf.alpha, 0.75 * alpha);
    EXPECT_LT(brdf.alpha, 1.35 * alpha);
    EXPECT_GT(brdf.specular_weight, 0.3);
    EXPECT_LT(brdf.specular_weight, 0.9);
  }
}

TEST(Measured, FitOfADiffuseTableIsTheCosine) {
  MeasuredBrdf brdf =
      resample(parse_merl_brdf(merl_bytes(4, 4, 4, [](int, int, int, int) { return 0.1; }), "m"));
  fit_sampling(brdf);
  EXPECT_EQ(brdf.specular_weight, 0);
  MeasuredBrdf black =
      resample(parse_merl_brdf(merl_bytes(4, 4, 4, [](int, int, int, int) { return 0.0; }), "m"));
  fit_sampling(black);
  EXPECT_EQ(black.specular_weight, 0);
  EXPECT_EQ(black.alpha, 1);
}

TEST(Measured, HolesTakeTheirNeighbours) {
  const MeasuredBrdf brdf = resample(parse_merl_brdf(
      merl_bytes(20, 20, 40, [](int, int h, int d, int) { return h < 15 && d < 15 ? 0.25 : -1; }), "m"));
  EXPECT_NEAR(brdf(direction(1.3, 0), direction(1.3, kPi)).g, 0.25, 1e-6);
  ASSERT_EQ(brdf.remarks.size(), 1u);
  EXPECT_NE(brdf.remarks[0].find("were not measured"), std::string::npos);
  const MeasuredBrdf empty =
      resample(parse_merl_brdf(merl_bytes(3, 3, 3, [](int, int, int, int) { return -1; }), "m"));
  EXPECT_EQ(empty(direction(0.5, 0), direction(0.5, 1)), glm::dvec3(0));
}

TEST(Measured, NegativeValuesAreCounted) {
  std::string text = "1\n500\n0.5 0 0.5 0 -1\n0.5 0 0.6 0 1\n";
  const CornellBrdf brdf = parse_cornell_brdf(text, "c");
  EXPECT_EQ(brdf.negatives, 1u);
  EXPECT_EQ(brdf.samples.at(0).value, glm::dvec3(0));
  EXPECT_NEAR(resample(brdf)(direction(0.5, 0), direction(0.6, 0)).g, 0.6, 0.2);  // two samples are enough
}

TEST(Measured, BrokenTextIsNamedByItsLine) {
  const auto error = [](const std::string& text) {
    return error_of([&] { parse_cornell_brdf(text, "c.brdf"); });
  };
  EXPECT_EQ(error(""), "c.brdf: the table ends before the number of wavelengths");
  EXPECT_EQ(error("2.5"), "c.brdf:1: the number of wavelengths must be 1 to 4096, not 2.5");
  EXPECT_EQ(error("1000000000"), "c.brdf:1: the number of wavelengths must be 1 to 4096, not 1000000000");
  EXPECT_EQ(error("2\n500\n400"), "c.brdf:3: wavelengths must rise; 400 follows 500");
  EXPECT_EQ(error("1\n500\n"), "c.brdf:2: the table has no rows");
  EXPECT_EQ(error("1\n500\n.1 0 .1 0 x"), "c.brdf:3: a BRDF table holds numbers only, not \"x\"");
  EXPECT_EQ(error("1\n500\n.1 0 .1 0"), "c.brdf:3: the table ends before the last value of its row");
  EXPECT_EQ(error("1\n500\n1.6 0 .1 0 1"), "c.brdf:3: a theta must lie between 0 and pi/2, not at 1.6");
  EXPECT_EQ(error("1\n500\n.1 0 .1 nan 1"), "c.brdf:3: a BRDF table holds numbers only, not \"nan\"");
}

TEST(Measured, BrokenBinariesAreNamed) {
  const auto error = [](const std::string& bytes) { return error_of([&] { parse_merl_brdf(bytes, "m"); }); };
  EXPECT_EQ(error("short"), "m: this is no MERL table: it does not start with three sizes from 1 to 4096");
  std::string bytes = merl_bytes(2, 2, 2, [](int, int, int, int) { return 1; });
  EXPECT_EQ(error(bytes + "x"), "m: a MERL table of 2 x 2 x 2 has 204 bytes, this file has 205");
  const int huge[3] = {4096, 4096, 4096};
  std::memcpy(bytes.data(), huge, 12);
  EXPECT_NE(error(bytes).find("has 1649267441676 bytes"), std::string::npos);
  const int negative[3] = {-2, 2, 2};
  std::memcpy(bytes.data(), negative, 12);
  EXPECT_NE(error(bytes).find("no MERL table"), std::string::npos);
}

TEST(Measured, FilesAreToldApartByTheirContents) {
  const test::Folder folder;
  const std::string merl =
      folder.write("a.brdf", merl_bytes(2, 2, 2, [](int, int, int, int) { return 0.1; }));
  EXPECT_NEAR(read_measured_brdf(merl)(direction(0.3, 0), direction(0.4, 2)).r, 0.1, 1e-6);
  const std::string text =
      folder.write("b.brdf", cornell_text([](double, double, double) { return 1.5 / kPi; }));
  const MeasuredBrdf bright = read_measured_brdf(text);
  ASSERT_EQ(bright.remarks.size(), 1u);
  EXPECT_EQ(bright.remarks[0], "it reflects up to 1.50 times the light that arrives");
}

/// The tables of Cornell, where they are at hand.
TEST(Measured, CornellTablesAreFollowed) {
  const std::filesystem::path path = std::filesystem::path(CAPCON_SHARED_DIR) / "scenes/brdf/cayman.brdf";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const CornellBrdf measured = parse_cornell_brdf(text, "cayman");
  EXPECT_EQ(measured.samples.size(), 1439u);
  const MeasuredBrdf brdf = resample(measured);
  std::vector<double> errors;
  for (const BrdfSample& s : measured.samples) {
    const double table = brdf(direction(s.theta_in, s.phi_in), direction(s.theta_out, s.phi_out)).g;
    errors.push_back(std::abs(table - s.value.g) / (s.value.g + 0.01));
  }
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.1);  // Gaussian weights smooth: half of the samples within a tenth
}

}  // namespace
}  // namespace capcon
