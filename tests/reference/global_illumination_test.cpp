// Instant global illumination against path tracing, which shares only surfaces, BSDFs and lights with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.h"
#include "reference/global.h"

namespace capcon {
namespace {

using test::Estimate;
using test::kCorner;
using test::kCornerLamp;
using test::lamp;
using test::matte;
using test::mean_of;

struct Named {
  const char* name;
  std::string text;
};
void PrintTo(const Named& named, std::ostream* out) {
  *out << named.name;
}

const std::string kPlastic =
    "Material \"plastic\" \"rgb Kd\" [.4 .5 .6] \"rgb Ks\" [.5 .5 .5] \"float roughness\" .2 ";
const std::string kMetal =
    "Material \"conductor\" \"spectrum eta\" \"metal-Cu-eta\" \"spectrum k\" \"metal-Cu-k\" \"float "
    "roughness\" .3 ";
/// A pyramid with a rounded look: the vertices' normals lean outwards from those of its faces.
const std::string kTent =
    "Shape \"trianglemesh\" \"point3 P\" [-.4 -.4 .1 .4 -.4 .1 .4 .4 .1 -.4 .4 .1 0 0 .5] "
    "\"normal N\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1 0 0 1] \"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4]\n";

const std::vector<Named> kScenes = {
    {"disk", matte(0.8) + kCorner + kCornerLamp},
    {"glossy receiver", kPlastic + kCorner + kCornerLamp},
    {"metal", kMetal + kCorner + kCornerLamp},
    {"shading normals", matte(0.8) + kCorner + kTent + kCornerLamp},
    {"texture",
     "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"map.png\" "
     "Material \"diffuse\" \"texture reflectance\" \"t\" " +
         kCorner + kCornerLamp},
    {"ring", matte(0.8) + kCorner +
                 lamp("Translate 0 .3 .4 Scale .5 1 1 Shape \"disk\" \"float radius\" .5 \"float "
                      "innerradius\" .25",
                      "\"bool twosided\" true ")},
    {"sphere", matte(0.8) + kCorner + lamp("Translate .2 0 .6 Shape \"sphere\" \"float radius\" .3")},
    {"sphere about it",
     matte(0.5) + kCorner + lamp("ReverseOrientation Shape \"sphere\" \"float radius\" 4")},
    {"ellipsoid", matte(0.8) + kCorner + lamp("Translate .2 0 .6 Scale .2 .4 .3 Shape \"sphere\"")},
    {"rectangle", matte(0.8) + kCorner +
                      lamp("Shape \"trianglemesh\" \"point3 P\" [-.2 -.2 1 -.2 .5 1 .5 .5 1.2 .5 -.2 1.2] "
                           "\"integer indices\" [0 1 2 0 2 3]")},
    {"mesh", matte(0.8) + kCorner +
                 lamp("Translate .2 .1 .6 Scale .3 .3 .3 Shape \"trianglemesh\" \"point3 P\" "
                      "[-1 -1 -1 1 -1 -1 0 1 -1 0 0 1] \"integer indices\" [0 1 2 0 1 3 1 2 3 2 0 3]",
                      "\"bool twosided\" true ")},
    {"constant environment", matte(0.8) + kCorner + "LightSource \"infinite\" \"rgb L\" [1 1 1]\n"},
    {"environment map", matte(0.8) + kCorner + "LightSource \"infinite\" \"string mapname\" \"map\"\n"},
    {"distant light",
     matte(0.8) + kCorner + "LightSource \"distant\" \"point3 from\" [2 1 3] \"point3 to\" [0 0 0]\n"},
    {"point light", matte(0.8) + kCorner + "LightSource \"point\" \"point3 from\" [.3 .2 .6]\n"},
    {"several lights", kPlastic + kCorner + kCornerLamp +
                           lamp("Translate -.3 .6 .2 Shape \"sphere\" \"float radius\" .1") +
                           "LightSource \"point\" \"point3 from\" [.5 -.3 .6] \"rgb I\" [.2 .2 .5]\n" +
                           "LightSource \"distant\" \"point3 from\" [2 1 3] \"point3 to\" [0 0 0]\n"},
};

/// What path tracing finds.
Estimate truth_of(const Reference& reference, bool only_indirect = true, std::uint32_t samples = 1024) {
  PathTracingJob paths;
  paths.samples = samples;
  paths.only_indirect = only_indirect;
  return test::over_seeds(reference, paths, 8);
}
void expect_agreement(const Reference& reference, const GlobalIlluminationJob& job, int seeds,
                      const Estimate& truth) {
  const Estimate ours = test::over_seeds(reference, job, seeds);
  const double error = std::hypot(ours.error, truth.error);
  EXPECT_LT(std::abs(ours.mean - truth.mean), 4 * error) << ours.mean << " " << truth.mean;
  EXPECT_LT(error, 0.035 * truth.mean);  // or the test would say nothing
}

class GlobalIllumination : public testing::TestWithParam<Named> {};

TEST_P(GlobalIllumination, CompensationAgreesWithPathTracing) {
  const Scene scene = test::corner_view(GetParam().text, 3);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.sampler = job.direct.sampler = "sobol-owen";
  expect_agreement(reference, job, 128, truth_of(reference));
}

INSTANTIATE_TEST_SUITE_P(Lights, GlobalIllumination, testing::ValuesIn(kScenes), [](const auto& info) {
  std::string name = info.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(c); });
  return name;
});

TEST(GlobalIlluminationEstimates, AreTheSameByEverySampler) {
  // Were points of different bounces in the same order, jittered sets would be 9 % too dark here.
  const Scene scene = test::corner_view(matte(0.8) + kCorner + kCornerLamp);
  const Reference reference(scene);
  const Estimate truth = truth_of(reference);
  for (const char* sampler : {"random", "jittered", "capcon-domain"}) {
    GlobalIlluminationJob job = test::global_job();
    job.sampler = job.direct.sampler = sampler;
    expect_agreement(reference, job, 64, truth);
    job.partition = job.direct.partition = false;
    expect_agreement(reference, job, 64, truth);
  }
}

TEST(GlobalIlluminationEstimates, WithoutAndWithClamping) {
  // No corner: a wall that a floor does not touch. Else single points would be as bright as all others.
  const std::string wall =
      "Shape \"trianglemesh\" \"point3 P\" [-2 1.5 .5 2 1.5 .5 2 1.5 2 -2 1.5 2] \"integer indices\" [0 1 2 "
      "0 2 "
      "3]\n";
  const std::string floor =
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"integer indices\" [0 1 2 0 2 3]\n";
  const Scene scene = test::view_of(matte(0.8) + wall + floor + kCornerLamp, {0, -1, 1}, {0, 0, 0}, 40, 3);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.sampler = "sobol-owen";
  job.clamping = Clamping::none;
  expect_agreement(reference, job, 96, truth_of(reference));
  job.only_indirect = false;
  job.clamping = Clamping::compensate;
  expect_agreement(reference, job, 64, truth_of(reference, false));
}

TEST(GlobalIlluminationEstimates, LightLeavesSurfacesBelowTheirShadingNormals) {
  // The sun shines straight down on a floor whose shading normals lean by 60 degrees away from a wall. All
  // that the wall has, and hands on to a small plate on the floor, leaves the floor below those normals:
  // there the geometric normal stands in (docs/direct.md).
  const std::string floor =
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"normal N\" [.866 0 .5 .866 0 .5 "
      ".866 0 .5 .866 0 .5] \"integer indices\" [0 1 2 0 2 3]\n";
  const std::string wall =
      "Shape \"trianglemesh\" \"point3 P\" [-1.1 -1 0 -1.1 1 0 -1.1 1 1 -1.1 -1 1] \"integer indices\" [0 1 "
      "2 "
      "0 2 3]\n";
  const std::string plate = "Translate -.5 0 .05 Shape \"disk\" \"float radius\" .05\n";
  const std::string sun = "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n";
  const Scene scene =
      test::view_of(matte(0.8) + sun + floor + wall + plate, {0.5, -0.4, 1}, {-0.5, 0, 0.05}, 1e-9, 1);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.sampler = "sobol-owen";
  job.paths = 2048;
  expect_agreement(reference, job, 128, truth_of(reference, true, 1 << 15));
}

TEST(GlobalIlluminationEstimates, ClampingDarkensCorners) {
  const Scene scene = test::corner_view(matte(0.8) + kCorner + kCornerLamp);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  double last = 0;
  for (const double limit : {0.1, 1.0, 10.0}) {
    job.limit = limit;
    job.clamping = Clamping::clamp;
    const double clamped = mean_of(reference.render(job).image);
    job.clamping = Clamping::compensate;
    EXPECT_LT(clamped, (limit < 5 ? 0.95 : 1.0) * mean_of(reference.render(job).image)) << limit;
    EXPECT_GT(clamped, last);
    last = clamped;
  }
}

TEST(GlobalIlluminationEstimates, TheDefaultLimitIsTheScenes) {
  const Scene scene = test::corner_view(matte(0.8) + kCorner + kCornerLamp);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.limit = 0;
  const RenderResult by_default = reference.render(job);
  job.limit = default_geometry_limit(scene);
  EXPECT_EQ(reference.render(job).image.pixels, by_default.image.pixels);
  EXPECT_EQ(by_default.virtual_lights, reference.trace_virtual_lights(job).lights.size());
  EXPECT_GT(by_default.rays, by_default.virtual_lights);
}

TEST(GlobalIlluminationEstimates, BlocksAndImageSamplesUseTheirSets) {
  const Scene scene = test::corner_view(matte(0.8) + kCorner + kCornerLamp);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.clamping = Clamping::clamp;
  job.sets = 8;
  const VirtualLights all = reference.trace_virtual_lights(job);
  // Light from one set alone: which pixels show it?
  const auto alone = [&](const GlobalIlluminationJob& j, std::uint32_t set) {
    VirtualLights one = all;
    for (std::uint32_t k = 0; k < one.lights.size(); ++k) {
      if (k < one.first[set] || k >= one.first[set + 1]) one.lights[k].flux = glm::dvec3(0);
    }
    return reference.render(j, one).image;
  };
  GlobalIlluminationJob blocks = job;
  blocks.block = 2;
  for (std::uint32_t set = 0; set < 8; ++set) {
    const Image in_blocks = alone(blocks, set), everywhere = alone(job, set);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const bool shown = std::uint32_t(x % 2 + 2 * (y % 2)) == set % 4;
        const float expected = shown ? 4 * everywhere.at(x, y, 0) : 0;  // of 2 sets in place of 8
        EXPECT_NEAR(in_blocks.at(x, y, 0), expected, 1e-6 * expected) << set << " " << x << " " << y;
      }
    }
  }
  // A pinhole: all image samples of a pixel see the same point, and use each set twice.
  const Scene point =
      test::view_of(matte(0.8) + kCorner + kCornerLamp, {0.9, -0.9, 0.9}, {-1, 0.5, 0.4}, 1e-7, 4);
  const Reference narrow(point);
  GlobalIlluminationJob jittered = job;
  jittered.direct.position = PixelPosition::jittered;
  jittered.direct.image_samples = 16;
  const float expected = narrow.render(job, all).image.at(1, 2, 0);
  EXPECT_NEAR(narrow.render(jittered, all).image.at(1, 2, 0), expected, 1e-5 * expected);
  jittered.direct.image_samples = 12;
  EXPECT_THROW(narrow.render(jittered, all), InputError);
}

TEST(GlobalIlluminationEstimates, TwoSidedOnesLeakThroughThinWalls) {
  // A floor under a roof that the sun shines on. The roof's VPLs light the floor as much as they would had
  // the sun shone from below.
  const std::string floor = matte(0.8) + test::kFloor;
  const std::string roof =
      "Shape \"trianglemesh\" \"point3 P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1] \"integer indices\" [0 1 2 0 2 3]\n";
  const Scene scene = test::view_of(floor + roof + "LightSource \"distant\" \"point3 from\" [1 2 3]\n",
                                    {0.1, 0.1, 0.5}, {0, 0, 0}, 20, 2);
  const Reference reference(scene);
  GlobalIlluminationJob job = test::global_job();
  job.sets = 1;
  VirtualLight on_roof;
  on_roof.position = {0.2, 0.3, 1};
  on_roof.normal = on_roof.shading_normal = {0, 0, 1};
  on_roof.arriving = glm::normalize(glm::dvec3(1, 2, 3));
  on_roof.flux = glm::dvec3(2);
  on_roof.material = 0;
  const VirtualLights lights{{on_roof}, {0, 1}};
  job.clamping = Clamping::clamp;
  VirtualLights turned = lights;
  for (VirtualLight& y : turned.lights) {
    y.normal = y.shading_normal = {0, 0, -1};
    y.arriving.z = -y.arriving.z;
    y.position.z -= 1e-9;
  }
  EXPECT_EQ(mean_of(reference.render(job, lights).image), 0);
  const double expected = mean_of(reference.render(job, turned).image);
  EXPECT_GT(expected, 0);
  job.two_sided = true;
  EXPECT_NEAR(mean_of(reference.render(job, lights).image), expected, 1e-6 * expected);
}

TEST(GlobalIlluminationEstimates, AreTheSameBitsForAnyNumberOfThreads) {
  const Scene scene = test::corner_view(matte(0.8) + kCorner + kCornerLamp);
  const Reference reference(scene);
  const char* before = std::getenv("CAPCON_THREADS");
  const std::string kept = before ? before : "";
  std::vector<std::vector<float>> images, paths;
  for (const char* threads : {"1", "3"}) {
    setenv("CAPCON_THREADS", threads, 1);
    images.push_back(reference.render(test::global_job()).image.pixels);
    paths.push_back(reference.render(PathTracingJob{}).image.pixels);
  }
  before ? setenv("CAPCON_THREADS", kept.c_str(), 1) : unsetenv("CAPCON_THREADS");
  EXPECT_EQ(images[0], images[1]);
  EXPECT_EQ(paths[0], paths[1]);
}

TEST(GlobalIlluminationEstimates, StayFiniteAtTheExtremes) {
  const std::string sliver =
      "Shape \"trianglemesh\" \"point3 P\" [0 0 .5 1 1 .5 .5 .5 .5] \"integer indices\" [0 1 2 0 0 1]\n";
  for (const double albedo : {0.0, 0.8, 1.0}) {
    const Scene scene = test::corner_view(matte(albedo) + sliver + kCorner + kCornerLamp);
    const Reference reference(scene);
    for (const Clamping clamping : {Clamping::none, Clamping::clamp, Clamping::compensate}) {
      GlobalIlluminationJob job = test::global_job();
      job.clamping = clamping;
      VirtualLights lights = reference.trace_virtual_lights(job);
      // One next to where a pixel looks, and one just there.
      const RenderResult plain = reference.render(job, lights);
      VirtualLight& near = lights.lights[lights.first[0]];
      near.position = {-1 + 1e-6, 1 - 1e-6, 1e-6};
      near.normal = near.shading_normal = {0, 0, 1};
      near.arriving = {0, 0, 1};
      const RenderResult close = reference.render(job, lights);
      for (const RenderResult* r : {&plain, &close}) {
        for (const float v : r->image.pixels) EXPECT_TRUE(std::isfinite(v) && v >= 0);
      }
      EXPECT_EQ(mean_of(plain.image) > 0, albedo > 0);
    }
  }
}

TEST(GlobalIlluminationEstimates, SayWhereThereIsNoLight) {
  const auto message = [](const std::string& text) {
    const Scene scene = test::corner_view(text);
    const Reference reference(scene);
    try {
      reference.render(test::global_job());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(kCorner), testing::HasSubstr("no light that emits"));
  const std::string away = lamp("Translate 0 0 3 Shape \"disk\"");
  EXPECT_THAT(message(kCorner + away), testing::HasSubstr("no light path hits"));
}

}  // namespace
}  // namespace capcon
