#include "reference/bsdf.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>
#include <string>

#include "reference/chi_square.h"

namespace capcon {
namespace {

using reference::Bsdf;
using std::numbers::pi;

glm::dvec3 direction(double degrees, double azimuth = 0.4) {
  const double theta = degrees * pi / 180;
  return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

/// A glossy lobe in half vectors over a grey base, coarse enough to show the table's facets.
MeasuredBrdf synthetic_table() {
  MeasuredBrdf table;
  for (int h = 0; h < MeasuredBrdf::kHalf; ++h) {
    const double t = double(h) / (MeasuredBrdf::kHalf - 1), theta = t * t * pi / 2;
    const float lobe = float(0.05 + 2 * std::exp(-theta * theta / 0.02));
    table.values.insert(table.values.end(), MeasuredBrdf::kDifference * MeasuredBrdf::kAzimuth,
                        glm::vec3(lobe, lobe / 2, lobe / 4));
  }
  table.specular_weight = 0.6;
  table.alpha = 0.2;
  return table;
}

struct Named {
  std::string name;
  Material material;
};

/// All kinds of materials, glossy ones at three alphas.
std::vector<Named> materials() {
  std::vector<Named> all;
  Material m;
  m.reflectance = {0.7, 0.5, 0.3};
  all.push_back({"diffuse", m});
  for (const double alpha : {0.05, 0.3, 1.0}) {
    const std::string end = fmt::format(" {}", alpha);
    Material metal;
    metal.kind = MaterialKind::conductor;
    metal.eta = {0.2, 0.9, 1.1};
    metal.k = {3.9, 2.4, 2.2};
    metal.alpha = alpha;
    all.push_back({"conductor" + end, metal});
    Material plastic;
    plastic.kind = MaterialKind::plastic;
    plastic.reflectance = {0.7, 0.5, 0.3};
    plastic.specular = {0.3, 0.4, 0.2};
    plastic.eta = glm::dvec3(1.5);
    plastic.alpha = alpha;
    for (const auto& [name, coat] : {std::pair{"added", Coat::added},
                                     {"substrate", Coat::substrate},
                                     {"transmitted", Coat::transmitted}}) {
      plastic.coat = coat;
      all.push_back({name + end, plastic});
    }
  }
  Material measured;
  measured.kind = MaterialKind::measured;
  all.push_back({"measured", measured});
  return all;
}

class BsdfTest : public testing::Test {
 protected:
  Bsdf bsdf(const Material& m) const {
    const bool measured = m.kind == MaterialKind::measured;
    return {m, m.reflectance, m.coat == Coat::transmitted ? inner_reflectance(m.eta.x) : 0,
            measured ? &table_ : nullptr};
  }
  MeasuredBrdf table_ = synthetic_table();
};

TEST_F(BsdfTest, SamplesAreAsDenseAsTheirPdfSays) {
  for (const auto& [name, material] : materials()) {
    const Bsdf b = bsdf(material);
    for (const double degrees : {0.0, 40.0, 75.0, 88.0}) {
      const glm::dvec3 out = direction(degrees);
      const test::ChiSquare c = test::chi_square(
          glm::dvec3(-out.x, -out.y, out.z),
          [&](const glm::dvec2& u, double choice) { return b.sample(out, u, choice); },
          [&](const glm::dvec3& in) { return b.pdf(in, out); });
      EXPECT_LT(c.sigmas, 4) << name << " at " << degrees;
      EXPECT_NEAR(c.integral + c.nothing, 1, 0.01) << name << " at " << degrees;
    }
  }
}

TEST_F(BsdfTest, AreReciprocalAndOneSided) {
  for (const auto& [name, material] : materials()) {
    const Bsdf b = bsdf(material);
    for (const double i : {1.0, 33.0, 62.0, 87.0}) {
      for (const double o : {5.0, 47.0, 80.0}) {
        const glm::dvec3 in = direction(i, 2.1), out = direction(o);
        const glm::dvec3 f = b.evaluate(in, out), g = b.evaluate(out, in);
        EXPECT_LT(glm::compMax(glm::abs(f - g)), 1e-12 * glm::compMax(f)) << name << " " << i << " " << o;
        EXPECT_GT(glm::compMin(f), 0) << name;
        for (const glm::dvec3& below : {-in, glm::dvec3(in.x, in.y, 0)}) {
          EXPECT_EQ(b.evaluate(below, out), glm::dvec3(0)) << name;
          EXPECT_EQ(b.evaluate(out, below), glm::dvec3(0)) << name;
          EXPECT_EQ(b.pdf(below, out), 0) << name;
        }
      }
    }
  }
}

/// Albedo by samples, with points of a grid.
glm::dvec3 albedo(const Bsdf& b, const glm::dvec3& out) {
  constexpr int kSide = 128;
  glm::dvec3 sum(0);
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::dvec2 u((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    const auto in = b.sample(out, u, std::fmod(i * 0.6180339887498949, 1));
    if (in) sum += b.evaluate(*in, out) * in->z / b.pdf(*in, out) / double(kSide * kSide);
  }
  return sum;
}

TEST_F(BsdfTest, SamplesAndValuesGiveTheAlbedoOfAQuadrature) {
  for (const auto& [name, material] : materials()) {
    const Bsdf b = bsdf(material);
    for (const double degrees : {20.0, 70.0}) {
      const glm::dvec3 out = direction(degrees);
      glm::dvec3 sum(0);
      // Midpoints in half vectors: d in = 4 (out . half) d half, denser towards the normal.
      constexpr int kRings = 300, kTurns = 300;
      for (int i = 0; i < kRings * kTurns; ++i) {
        const double t = (i / kTurns + 0.5) / kRings, theta = t * t * pi / 2,
                     phi = (i % kTurns + 0.5) / kTurns * 2 * pi;
        const glm::dvec3 half = direction(theta * 180 / pi, phi);
        const double facing = glm::dot(out, half);
        const glm::dvec3 in = 2 * facing * half - out;
        if (facing > 0 && in.z > 0)
          sum += b.evaluate(in, out) * in.z * 4.0 * facing * std::sin(theta) * (t * pi / kRings) *
                 (2 * pi / kTurns);
      }
      EXPECT_LT(glm::compMax(glm::abs(sum - albedo(b, out)) / sum), 0.01) << name << " at " << degrees;
    }
  }
}

TEST_F(BsdfTest, NothingReflectsMoreThanArrives) {
  for (auto [name, material] : materials()) {
    if (material.kind == MaterialKind::measured) continue;
    // As bright as they come; what lies under an added coat is added whatever the coat takes.
    const bool sum = material.kind == MaterialKind::plastic && material.coat == Coat::added;
    material.reflectance = glm::dvec3(sum ? 0 : 1);
    if (material.kind == MaterialKind::conductor) material.eta = glm::dvec3(0), material.k = glm::dvec3(1);
    if (material.coat != Coat::substrate) material.specular = glm::dvec3(1);
    const Bsdf b = bsdf(material);
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 88.0}) {
      const glm::dvec3 a = albedo(b, direction(degrees));
      EXPECT_LT(glm::compMax(a), 1 + 3e-3) << name << " at " << degrees;
      // A mirror, and a white base under a coat that is nearly smooth, reflect all of it.
      const bool all = material.kind == MaterialKind::conductor || material.coat == Coat::transmitted;
      if (all && material.alpha < 0.1 && degrees <= 60) {
        EXPECT_NEAR(a.x, 1, 0.01) << name << " at " << degrees;
      }
    }
  }
}

TEST_F(BsdfTest, VisibleNormalsAreTakenFromTheDocumentedPoints) {
  // The centre of the disk seen from above is the normal itself; for rough surfaces seen from the side, by
  // hand: alpha = 1, out at 60 degrees in the plane of x: V = out, T1 = (0, 1, 0), T2 = (-1/2, 0, sqrt(3)/2),
  // k = 3/4, centre of the disk: t = (0, 1/4), N = T2/4 + sqrt(15)/4 V.
  const glm::dvec3 up = reference::sample_visible_normal({0, 0, 1}, 0.3, {0.5, 0.5});
  EXPECT_LT(glm::distance(up, glm::dvec3(0, 0, 1)), 1e-12);
  const glm::dvec3 out = direction(60, 0), t2(-0.5, 0, std::sqrt(3) / 2);
  const glm::dvec3 n = t2 / 4.0 + std::sqrt(15) / 4 * out;
  const glm::dvec3 in = reference::sample_visible_normal(out, 1, {0.5, 0.5});
  EXPECT_LT(glm::distance(in, 2 * glm::dot(n, out) * n - out), 1e-12);
  // A quarter turn on the disk, u = (1, 1/2): t = (1, 0), replaced by (1, 0): N = T1.
  const glm::dvec3 side = reference::sample_visible_normal(out, 1, {1, 0.5});
  EXPECT_LT(glm::distance(glm::normalize(side + out), glm::dvec3(0, 1, 0)), 1e-5);
}

}  // namespace
}  // namespace capcon
