// Light paths: the power that they carry, and the points that they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include <numbers>

#include "reference/global.h"
#include "shading/light.h"
#include "shading/scene_bounds.h"

namespace capcon {
namespace {

using std::numbers::pi;
using test::Estimate;
using test::kBox;
using test::lamp;
using test::matte;

GlobalIlluminationJob light_job(std::uint32_t paths, std::uint32_t sets, const char* sampler) {
  GlobalIlluminationJob job;
  job.sampler = sampler;
  job.paths = paths;
  job.sets = sets;
  return job;
}

/// Flux of the sets' VPLs of a bounce (0: of all), over seeds.
Estimate flux(const Reference& reference, GlobalIlluminationJob job, std::uint32_t bounce = 0) {
  std::vector<double> sums;
  for (int seed = 0; seed < 32; ++seed) {
    job.direct.seed = 1000 + static_cast<std::uint32_t>(seed);
    const VirtualLights lights = reference.trace_virtual_lights(job);
    double sum = 0;
    for (const VirtualLight& y : lights.lights) sum += bounce == 0 || y.bounce == bounce ? y.flux.x : 0;
    sums.push_back(sum / lights.sets());
  }
  return test::estimate_of(sums);
}

void expect_flux(const Estimate& estimate, double expected, double most_error = 0.02) {
  EXPECT_LT(std::abs(estimate.mean - expected), 4 * estimate.error + 1e-6 * expected)
      << estimate.mean << " +- " << estimate.error << " for " << expected;
  EXPECT_LT(estimate.error, most_error * expected);
}

TEST(LightPaths, InAWhiteBoxTheirPowerIsAGeometricSeries) {
  const std::string light = "LightSource \"point\" \"rgb I\" [2 2 2] \"point3 from\" [.3 .2 -.4]\n";
  const double power = 8 * pi;
  for (const double rho : {0.5, 0.9}) {
    const Scene scene = test::parse_world(matte(rho) + kBox + light, {true, true, true});
    const Reference reference(scene);
    for (const char* sampler : {"random", "sobol-owen", "jittered"})
      expect_flux(flux(reference, light_job(64, 4, sampler)), power / (1 - rho));
    double expected = power;
    for (std::uint32_t bounce = 1; bounce <= 4; ++bounce, expected *= rho)
      expect_flux(flux(reference, light_job(64, 4, "sobol-owen"), bounce), expected, 0.03);
  }
}

struct Lit {
  const char* what;
  std::string light;
  double power;
};

TEST(LightPaths, EveryKindOfLightSendsItsPower) {
  // What hits the walls of a closed box first is all that its lights emit. What stands in their way reflects
  // nothing.
  const double disk = pi * pi * 0.09;
  const std::string quad =
      "Shape \"trianglemesh\" \"point3 P\" [-.3 -.2 0 .3 -.2 0 .3 .2 .1 -.3 .2 .1] \"integer indices\" [0 1 "
      "2 0 2 "
      "3]";
  const double slope = std::hypot(0.4, 0.1) * 0.6 * pi;
  const std::string both = "\"bool twosided\" true ";
  const std::vector<Lit> lights = {
      {"disk", lamp("Shape \"disk\" \"float radius\" .3"), disk},
      {"ring", lamp("Rotate 40 1 1 0 Shape \"disk\" \"float radius\" .3 \"float innerradius\" .15"),
       disk * 0.75},
      {"two-sided disk", lamp("Shape \"disk\" \"float radius\" .3", both), 2 * disk},
      {"sphere", lamp("Shape \"sphere\" \"float radius\" .3"), 4 * disk},
      {"inward sphere", lamp("ReverseOrientation Shape \"sphere\" \"float radius\" .3"), 4 * disk},
      {"two-sided sphere", lamp("Shape \"sphere\" \"float radius\" .3", both), 8 * disk},
      {"rectangle", lamp(quad), slope},
      {"flush rectangle",
       lamp("Translate 0 0 -1 Shape \"trianglemesh\" \"point3 P\" [-.3 -.3 0 .3 -.3 0 .3 "
            ".3 0 -.3 .3 0] \"integer indices\" [0 1 2 0 2 3]"),
       pi * 0.36},
      {"point and disk",
       lamp("Shape \"disk\" \"float radius\" .3") + "LightSource \"point\" \"point3 from\" [0 .5 .5]\n",
       disk + 4 * pi},
  };
  for (const Lit& lit : lights) {
    const Scene scene = test::parse_world(matte(0.5) + kBox + lit.light, {true, true, true});
    const Reference reference(scene);
    SCOPED_TRACE(lit.what);
    expect_flux(flux(reference, light_job(64, 1, "sobol-owen"), 1), lit.power, 0.03);
  }
}

TEST(LightPaths, EllipsoidsSendTheirPowerToTheirOwnSide) {
  for (const bool inward : {false, true}) {
    const std::string light = lamp(std::string(inward ? "ReverseOrientation " : "") +
                                   "Scale .3 .5 .2 Rotate 20 1 0 1 Shape \"sphere\"");
    const Scene scene = test::parse_world(matte(0.5) + kBox + light, {true, true, true});
    const Reference reference(scene);
    const VirtualLights lights = reference.trace_virtual_lights(light_job(256, 1, "sobol-owen"));
    const double first = lights.lights[0].flux.x;
    std::uint32_t hits = 0;
    for (const VirtualLight& y : lights.lights) {
      if (y.bounce != 1) continue;
      ++hits;
      EXPECT_EQ(y.flux.x, first);  // every path has the same power
      EXPECT_EQ(glm::length(y.position) < 0.6, inward);
    }
    EXPECT_EQ(hits, 256u);
  }
}

TEST(LightPaths, LightFromAfarFallsOnWhatIsInItsWay) {
  // A sphere of radius 1 beside a small far one that makes the bounds larger: its cross-section is pi.
  const std::string bodies =
      matte(0) + "Shape \"sphere\"\nTranslate 2 1 1 Shape \"sphere\" \"float radius\" 1e-3\n";
  const std::vector<Lit> lights = {
      {"distant", "LightSource \"distant\" \"rgb L\" [3 3 3] \"point3 from\" [1 2 3] \"point3 to\" [0 0 0]\n",
       3 * pi},
      {"constant", "LightSource \"infinite\" \"rgb L\" [1 1 1]\n", 4 * pi * pi},
      {"map", "LightSource \"infinite\" \"string mapname\" \"map\"\n", 0},
      {"two", "LightSource \"infinite\" \"rgb L\" [1 1 1]\nLightSource \"distant\" \"rgb L\" [3 3 3]\n",
       4 * pi * pi + 3 * pi}};
  for (const Lit& lit : lights) {
    const Scene scene = test::view_of(bodies + lit.light, {0, 0, 5}, {0, 0, 0}, 20, 1);
    const Reference reference(scene);
    double power = lit.power;
    if (power == 0) {  // pi times the map's radiance over all directions, of which its light knows the power
      const Lights read = read_lights(scene);
      const double radius = scene_bounds(scene).radius;
      power = read.values.at(0).power.x / (radius * radius);
    }
    SCOPED_TRACE(lit.what);
    expect_flux(flux(reference, light_job(1024, 1, "sobol-owen"), 1), power, 0.02);
  }
}

/// Where the paths of these sets first hit, in an order of place.
std::vector<glm::dvec3> first_hits(const VirtualLights& lights, std::uint32_t from, std::uint32_t to) {
  std::vector<glm::dvec3> hits;
  for (std::uint32_t set = from; set < to; ++set) {
    for (std::uint32_t k = lights.first[set]; k < lights.first[set + 1]; ++k) {
      if (lights.lights[k].bounce == 1) hits.push_back(lights.lights[k].position);
    }
  }
  std::sort(hits.begin(), hits.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  return hits;
}

TEST(LightPaths, SetsArePartsOfOneSet) {
  // All paths together are those of one set; of several lights, half-spaces and bounces alike.
  const std::string light = lamp("Translate 0 0 .5 Shape \"disk\" \"float radius\" .3");
  const Scene scene = test::parse_world(matte(0.5) + kBox + light, {true, true, true});
  const Reference reference(scene);
  // A distant light alone: where it hits depends on u.
  const std::string sun = "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n";
  const Scene sunny = test::parse_world(matte(0) + test::kFloor + sun, {true, true, true});
  const Reference under_sun(sunny);
  GlobalIlluminationJob parts = light_job(32, 8, "sobol-owen"), one = light_job(256, 1, "sobol-owen");
  EXPECT_EQ(first_hits(under_sun.trace_virtual_lights(parts), 0, 8),
            first_hits(under_sun.trace_virtual_lights(one), 0, 1));
  parts.partition = false;
  const VirtualLights naive = under_sun.trace_virtual_lights(parts);
  EXPECT_NE(first_hits(naive, 0, 8), first_hits(under_sun.trace_virtual_lights(one), 0, 1));
  // Sets of their own are as if each had been asked for alone but for the numbers of their dimensions.
  EXPECT_NE(first_hits(naive, 0, 1), first_hits(naive, 1, 2));
  // Bounces and fluxes are in order: by bounce, then by path.
  const VirtualLights lights = reference.trace_virtual_lights(light_job(32, 8, "random"));
  ASSERT_EQ(lights.sets(), 8u);
  ASSERT_EQ(lights.first.back(), lights.lights.size());
  for (std::uint32_t set = 0; set < 8; ++set) {
    for (std::uint32_t k = lights.first[set] + 1; k < lights.first[set + 1]; ++k) {
      const VirtualLight &a = lights.lights[k - 1], &b = lights.lights[k];
      EXPECT_TRUE(a.bounce < b.bounce || (a.bounce == b.bounce && a.path < b.path));
    }
  }
}

TEST(LightPaths, PartsHaveASmallerErrorThanSetsOfTheirOwn) {
  // The mean over all sets of where light falls on the box.
  const std::string light = lamp("Translate 0 0 .5 ReverseOrientation Shape \"disk\" \"float radius\" .3");
  const Scene scene = test::parse_world(matte(0) + kBox + light, {true, true, true});
  const Reference reference(scene);
  const auto error = [&](bool partition) {
    double squares = 0;
    GlobalIlluminationJob job = light_job(8, 32, "sobol-owen");
    job.partition = partition;
    for (std::uint32_t seed = 0; seed < 32; ++seed) {
      job.direct.seed = seed;
      glm::dvec3 mean(0);
      const auto hits = first_hits(reference.trace_virtual_lights(job), 0, 32);
      for (const glm::dvec3& p : hits) mean += p / double(hits.size());
      squares += mean.x * mean.x + mean.y * mean.y;
    }
    return squares;
  };
  EXPECT_LT(error(true), 0.7 * error(false));
}

}  // namespace
}  // namespace capcon
