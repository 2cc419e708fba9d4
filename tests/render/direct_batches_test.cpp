// How the work is cut on the device changes no bit of direct lighting, or only the order of its sums.
#include <algorithm>

#include "base/error.h"
#include "render/lit_scenes.h"
#include "render/renderer_state.h"

namespace capcon {
namespace {

using namespace testing;

const std::string kLamps = lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8");

const std::string kGround = kShades + patches({matte(0.6)}, 1);

DirectLightingJob jittered(std::uint32_t image, std::uint32_t integrator) {
  DirectLightingJob job = lit_job(integrator);
  job.image_samples = image;
  job.position = PixelPosition::jittered;
  return job;
}

// More samples than a dispatch holds, 2^19, are cut too.
TEST(DirectBatches, RowsAloneHaveTheBitsOfTheWholeImage) {
  Renderer renderer(look_at_patches(kGround + kLamps, 300, 200), lavapipe());
  for (const auto& job : {lit_job(12), jittered(3, 1)}) {
    const Image whole = renderer.render(job).image;
    for (const auto& [first, rows] : {std::pair{0, 1}, {5, 11}, {199, 1}}) {
      const Image part = renderer.render_rows(job, first, rows).image;
      ASSERT_EQ(part.height, rows);
      EXPECT_TRUE(
          std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + 3 * first * whole.width));
    }
  }
}

// Images larger than what the device holds at a time are rendered in bands.
TEST(DirectBatches, BandsHaveTheBitsOfTheWholeImage) {
  Renderer renderer(look_at_patches(kGround + kLamps), lavapipe());
  for (const auto& job : {lit_job(4), jittered(3, 2)}) {
    renderer.state().band_pixels = 32 * 24;
    const auto whole = renderer.render(job).image.pixels;
    for (const std::size_t pixels : {100u, 767u}) {
      renderer.state().band_pixels = pixels;
      EXPECT_EQ(renderer.render(job).image.pixels, whole) << pixels;
    }
  }
}

TEST(DirectBatches, SameJobSameBitsWhateverRanBetween) {
  const Scene scene = look_at_patches(kGround + kLamps);
  Renderer first(scene, lavapipe()), second(scene, lavapipe());
  DirectLightingJob job = jittered(4, 4), other = job;
  const auto pixels = first.render(job).image.pixels;
  other.sampler = "capcon";  // a larger table than the next one's
  other.integrator_samples = 64;
  second.render(other);
  EXPECT_EQ(second.render(job).image.pixels, pixels);
  job.seed += 1;
  EXPECT_NE(second.render(job).image.pixels, pixels);
}

TEST(DirectBatches, KeepingEverythingChangesNoBit) {
  RendererOptions all = lavapipe();
  all.keep_everything = true;
  const Scene scene = look_at_patches(kGround + kLamps);
  Renderer needed(scene, lavapipe()), everything(scene, all);
  for (const auto& job : {lit_job(4), jittered(2, 2)})
    EXPECT_EQ(needed.render(job).image.pixels, everything.render(job).image.pixels);
}

// More than 2^14 samples are summed in several pieces, and a pixel's samples may be more than a dispatch
// holds.
TEST(DirectBatches, ManySamplesAreCutIntoPieces) {
  const Scene scene = look_at_patches(kGround + kLamps, 3, 2, 5);
  Renderer renderer(scene, lavapipe());
  const Reference reference(scene);
  expect_agreement("40000", renderer, reference, lit_job(40000), 1e-5, 0);
  DirectLightingJob job = lit_job(64);
  job.image_samples = 300;  // pieces that end within an image sample's part
  expect_agreement("300 x 64", renderer, reference, job, 1e-5, 0);
  job.partition = false;
  expect_agreement("300 x 64, sets", renderer, reference, job, 1e-5, 0);
  const RenderResult result = renderer.render(job);
  EXPECT_EQ(result.rays, 6u * 300 * 64 * 2);
}

TEST(DirectBatches, OnePixelAndOneSample) {
  const Scene scene = look_at_patches(kGround + kLamps, 1, 1, 5);
  Renderer renderer(scene, lavapipe());
  const Reference reference(scene);
  expect_agreement("1", renderer, reference, lit_job(1), 1e-4, 0);
  expect_agreement("1, jittered", renderer, reference, jittered(1, 1), 1e-4, 0);
}

TEST(DirectBatches, NothingShinesOrReflects) {
  const Scene unlit = look_at_patches(kGround);
  Renderer dark(unlit, lavapipe());
  const RenderResult none = dark.render(lit_job());
  EXPECT_TRUE(
      std::all_of(none.image.pixels.begin(), none.image.pixels.end(), [](float v) { return v == 0; }));
  EXPECT_EQ(none.rays, 0u);
  const Scene black = look_at_patches(matte(0) + "Shape \"disk\" \"float radius\" 90 " + kLamps);
  Renderer dull(black, lavapipe());
  for (const Strategy s : {Strategy::power, Strategy::lights, Strategy::bsdf}) {
    const Image image = dull.render(lit_job(4, s)).image;
    EXPECT_TRUE(std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v == 0; }));
  }
  EXPECT_THROW(dull.render(lit_job(0)), InputError);
}

}  // namespace
}  // namespace capcon
