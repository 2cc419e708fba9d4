// Instant global illumination on the device: the reference's image with the same virtual lights, whatever way
// they are used.
#include "base/error.h"
#include "render/lit_rooms.h"

namespace capcon {
namespace {

using namespace testing;

class GlobalIllumination : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new Scene(furnished_corner());
    renderer_ = new Renderer(*scene_, lavapipe());
    reference_ = new Reference(*scene_);
  }
  static void TearDownTestSuite() {
    delete reference_;
    delete renderer_;
    delete scene_;
  }
  static void agree(const std::string& what, const GlobalIlluminationJob& job, double tolerance = 1e-4,
                    int grazing = 1) {
    expect_agreement(what, *renderer_, *reference_, job, tolerance, grazing);
  }
  static inline Scene* scene_ = nullptr;
  static inline Renderer* renderer_ = nullptr;
  static inline Reference* reference_ = nullptr;
};

TEST_F(GlobalIllumination, GathersAsTheReferenceDoes) {
  GlobalIlluminationJob job = room_job();
  job.only_indirect = true;
  job.sets = 4;
  for (const Clamping clamping : {Clamping::none, Clamping::clamp}) {
    job.clamping = clamping;
    agree(clamping == Clamping::none ? "unclamped" : "clamped", job);
  }
  job.two_sided = true;
  // Points of one plane, each off it by its own rounding, see each other's backs in a few dark pixels.
  agree("two-sided", job, 1e-4, 12);
}

TEST_F(GlobalIllumination, CompensatesAsTheReferenceDoes) {
  GlobalIlluminationJob job = room_job();
  agree("compensated", job, 1e-4, 2);
  for (const char* sampler : {"random", "capcon", "capcon-domain"}) {
    job.sampler = job.direct.sampler = sampler;
    job.direct.seed += 1;
    agree(sampler, job, 1e-4, 2);
  }
}

TEST_F(GlobalIllumination, JitteredImageSamplesUseOneSetEach) {
  GlobalIlluminationJob job = room_job();
  job.direct.position = PixelPosition::jittered;
  job.direct.image_samples = 4;
  agree("jittered", job, 1e-4, 4);
  job.partition = false;
  job.direct.partition = false;
  agree("sets of their own", job, 1e-4, 4);
}

TEST_F(GlobalIllumination, BlocksOfPixelsShareTheSetsOut) {
  GlobalIlluminationJob job = room_job();
  job.paths = 8;
  job.sets = 8;
  job.block = 2;
  agree("blocks of two", job, 1e-4, 2);
  job.sets = 9;
  job.block = 3;
  agree("blocks of three", job, 1e-4, 2);
}

// It is called after every dispatch, compensation's too, each time with at least what it said before.
TEST_F(GlobalIllumination, WhatTheCallerThrowsEndsTheJobAndTheNextHasTheSameBits) {
  const GlobalIlluminationJob job = room_job();
  int calls = 0;
  double last = 0;
  const Image whole = renderer_
                          ->render(job,
                                   [&](double fraction) {
                                     ++calls;
                                     EXPECT_GE(fraction, last);
                                     last = fraction;
                                   })
                          .image;
  EXPECT_NEAR(last, 1, 0.1) << "sets have about as many lights";
  ASSERT_GT(calls, 10);
  for (const int at : {1, calls / 2, calls}) {
    int call = 0;
    const auto thrower = [&](double) {
      if (++call == at) throw Failure("enough");
    };
    EXPECT_THROW(renderer_->render(job, thrower), Failure) << at;
    EXPECT_EQ(call, at) << "and then no more";
  }
  EXPECT_EQ(renderer_->render(job).image.pixels, whole.pixels);
}

// Rows rendered apart are cut differently into bands and pieces.
TEST_F(GlobalIllumination, RowsAreThoseOfTheWholeImage) {
  GlobalIlluminationJob job = room_job();
  job.sets = 4;
  job.block = 2;
  const Image whole = renderer_->render(job).image;
  const Image part = renderer_->render_rows(job, 5, 8).image;
  const std::vector<float> rows(whole.pixels.begin() + 3 * 32 * 5, whole.pixels.begin() + 3 * 32 * 13);
  EXPECT_EQ(part.pixels, rows);
  EXPECT_EQ(renderer_->render(job).image.pixels, whole.pixels);
}

TEST_F(GlobalIllumination, FetchVariantsGiveTheSameBits) {
  const GlobalIlluminationJob job = room_job();
  Renderer storage(*scene_, lavapipe("storage"));
  Renderer texel(*scene_, lavapipe("texel"));
  EXPECT_EQ(storage.render(job).image.pixels, texel.render(job).image.pixels);
}

TEST_F(GlobalIllumination, WantsImageSamplesForAllSets) {
  GlobalIlluminationJob job = room_job();
  job.direct.position = PixelPosition::jittered;
  job.direct.image_samples = 3;
  EXPECT_THROW(renderer_->render(job), InputError);
  EXPECT_THROW(renderer_->render(PathTracingJob{}), InputError);
}

TEST(GlobalIlluminationScenes, InstancesAreLitAsTheReferenceSays) {
  const std::string box = "ObjectBegin \"box\" " + within(matte(0.7) + "Scale .2 .2 .2 " + test::kBox) +
                          "ObjectEnd\n" + within("Translate -.4 .4 .25 ObjectInstance \"box\" ") +
                          within("Translate .3 -.2 .3 Rotate 30 0 0 1 ObjectInstance \"box\" ");
  const Scene scene = furnished_corner(test::kCornerLamp + box);
  Renderer renderer(scene, lavapipe("auto", "two-level"));
  expect_agreement("instances", renderer, Reference(scene), room_job(), 1e-4, 3);
}

// Extreme cases: finite, and as the reference has them.
TEST(GlobalIlluminationScenes, StayFiniteWhereVirtualLightsAreNear) {
  // The camera looks into the corner itself from a hundredth away, where VPLs come to lie within 1e-6.
  Scene scene = test::view_of(within(matte(0.8) + test::kCorner) +
                                  lamp("Translate -.999 .999 .001 Shape \"sphere\" \"float radius\" .0005"),
                              {-0.99, 0.99, 0.01}, {-1, 1, 0}, 40, 16);
  Renderer renderer(scene, lavapipe());
  GlobalIlluminationJob job = room_job();
  job.paths = 256;
  for (const Clamping clamping : {Clamping::none, Clamping::clamp, Clamping::compensate}) {
    job.clamping = clamping;
    for (const double limit : {1e-3, 1e12}) {
      job.limit = limit;
      for (const float v : renderer.render(job).image.pixels) ASSERT_TRUE(std::isfinite(v)) << limit;
    }
  }
}

// A lamp that reflects, a triangle without area, and a camera that the light's closed box keeps out.
TEST(GlobalIlluminationScenes, TakesLampsDegenerateTrianglesAndClosedBoxesAsTheyAre) {
  const std::string sliver =
      within(matte(0.9) +
             "Shape \"trianglemesh\" \"point3 P\" [-.5 .5 .3 .5 -.5 .3 0 0 .3 0 0 .3] \"integer "
             "indices\" [0 1 2 2 3 2 0 0 0] ");
  const Scene scene =
      furnished_corner(sliver + lamp(matte(0.8) + "Translate -.4 .2 .9 Shape \"sphere\" \"float radius\" .2",
                                     "\"bool twosided\" true "));
  Renderer renderer(scene, lavapipe());
  expect_agreement("sliver and lamp", renderer, Reference(scene), room_job(), 1e-4, 3);

  const Scene box =
      test::view_of(within(matte(0.8) + test::kBox) + lamp("Shape \"sphere\" \"float radius\" .2"), {3, 2, 2},
                    {0, 0, 0}, 40, 16);
  Renderer outside(box, lavapipe());
  for (const float v : outside.render(room_job()).image.pixels) ASSERT_EQ(v, 0);
}

TEST(GlobalIlluminationScenes, SaysWhenNoPathHitsAnything) {
  const std::string away = lamp("Translate 0 0 2 Shape \"disk\" \"float radius\" .1");  // shines upwards
  Renderer renderer(test::corner_view(within(matte(0.5) + "Shape \"disk\" \"float radius\" 1 ") + away),
                    lavapipe());
  EXPECT_THROW(renderer.render(room_job()), InputError);
  Renderer dark(test::corner_view(within(matte(0.5) + test::kCorner)), lavapipe());
  EXPECT_THROW(dark.render(room_job()), InputError);
}

}  // namespace
}  // namespace capcon
