// How the work is cut into dispatches changes no bit, and the device's clock decides it.
#include "render/batches.h"

#include <numeric>

#include "gpu/kernel.h"
#include "render/dispatch.h"
#include "render/lit_rooms.h"
#include "render/renderer_state.h"
#include "spirv/points_storage.h"

namespace capcon {
namespace {

using namespace testing;

constexpr std::uint64_t kAdaptive = 0;

/// Renders of one job on one device, with other batches each time.
void expect_same_bits(const Scene& scene, const Job& job) {
  RendererOptions options = lavapipe();
  options.validate = false;  // many dispatches; others run under it
  options.batch_lanes = 1 << 17;
  Renderer renderer(scene, options);
  const std::vector<float> whole = renderer.render(job).image.pixels;
  for (const std::uint64_t lanes :
       {std::uint64_t(1000), std::uint64_t(1) << 12, std::uint64_t(1) << 15, kAdaptive}) {
    renderer.state().fixed_lanes = lanes;
    EXPECT_EQ(renderer.render(job).image.pixels, whole) << lanes << " lanes";
  }
}

// A dispatch of rows of a wide image may have more groups than usual: all are to be visited once.
TEST(Batches, StridesVisitEveryGroupAndFitAWord) {
  for (const std::uint32_t groups : {1u, 2u, 63u, 4096u, 8192u, 65521u, 65536u, 65537u, 131072u, 262144u}) {
    const std::uint32_t stride = spreading_stride(groups);
    EXPECT_EQ(std::gcd(stride, groups), 1u) << groups;
    EXPECT_LT(std::uint64_t(groups - 1) * stride, std::uint64_t(1) << 32) << groups;
  }
}

TEST(Batches, NoBitOfAmbientOcclusionDependsOnThem) {
  Scene scene = furnished_corner();
  scene.film = {61, 37, ""};
  AmbientOcclusionJob job;
  job.sampler = "sobol-owen";
  job.samples = 25;
  expect_same_bits(scene, job);
  job.position = PixelPosition::jittered;
  job.samples = 5;
  expect_same_bits(scene, job);
}

TEST(Batches, NoBitOfDirectLightingDependsOnThem) {
  Scene scene = furnished_corner();
  scene.film = {61, 37, ""};
  DirectLightingJob job;
  job.sampler = "sobol-xor";
  job.integrator_samples = 25;
  expect_same_bits(scene, job);
  job.image_samples = 3;
  job.integrator_samples = 5;
  job.position = PixelPosition::jittered;
  expect_same_bits(scene, job);
  scene.film = {3, 1, ""};
  job = {};
  job.sampler = "sobol-xor";
  job.integrator_samples = 5000;  // more than a dispatch has for a pixel
  expect_same_bits(scene, job);
}

TEST(Batches, NoBitOfGlobalIlluminationDependsOnThem) {
  Scene scene = furnished_corner();
  scene.film = {31, 17, ""};
  GlobalIlluminationJob job = room_job();
  job.paths = 300;  // 1200 paths, and 1581 rays to compensate by: more than a small batch
  job.sets = 4;
  job.gather = 3;
  job.limit = 0.05;  // much to compensate
  expect_same_bits(scene, job);
  job.paths = 60;
  job.block = 2;
  expect_same_bits(scene, job);
}

TEST(Batches, PointsAreTheSame) {
  const Scene scene = furnished_corner();
  const auto sampler = make_sampler("sobol-owen", 25, 3);
  RendererOptions options = lavapipe();
  options.batch_lanes = 1000;
  Renderer small(scene, options), large(scene, lavapipe());
  EXPECT_EQ(small.sample_points(*sampler, 300, 4), large.sample_points(*sampler, 300, 4));
}

class BatchSizes : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kMost = 1 << 19;
  gpu::Instance instance_{false};
  gpu::Device device_{instance_, instance_.choose("lavapipe")};
  gpu::Kernel kernel_{
      device_, k_points_storage_spirv, {{3, gpu::Access::storage}, {6, gpu::Access::storage}}, {}, 112};
  Batches batches_{kMost};

  /// The longest of `count` dispatches in a row where a lane takes so long, in seconds.
  double longest(double seconds_a_lane, int count) {
    double most = 0;
    for (int i = 0; i < count; ++i) {
      const std::uint64_t lanes = batches_.lanes(kernel_);
      most = std::max(most, static_cast<double>(lanes) * seconds_a_lane);
      batches_.took(kernel_, lanes, static_cast<double>(lanes) * seconds_a_lane);
    }
    return most;
  }
};

TEST_F(BatchSizes, GrowWhereTheDeviceIsFast) {
  EXPECT_LT(longest(1e-9, 4), 0.001);
  EXPECT_EQ(batches_.lanes(kernel_), kMost);
}

TEST_F(BatchSizes, StayShortWhereItIsSlow) {
  for (const double seconds : {1e-6, 5e-6, 2e-5, 5e-5}) {
    batches_ = Batches(kMost);
    EXPECT_LT(longest(seconds, 1), 1.7) << "the first";
    EXPECT_LT(longest(seconds, 20), 2.01 * Batches::kAim);
    EXPECT_GT(longest(seconds, 1), 0.4 * Batches::kAim) << "no smaller than need be";
  }
}

// A part of the image that costs eight times as much is slow once at most.
TEST_F(BatchSizes, FollowWhatALaneCosts) {
  longest(1e-6, 10);
  EXPECT_LT(longest(8e-6, 1), 2.01);
  EXPECT_LT(longest(8e-6, 10), 1.01 * Batches::kAim);
  longest(1e-7, 10);
  EXPECT_EQ(batches_.lanes(kernel_), 125000u) << "1 s where all is as slow again";
}

TEST_F(BatchSizes, LittleWorkThatTakesLongALaneShrinksNothing) {
  longest(1e-9, 10);
  batches_.took(kernel_, 64, 0.01);
  EXPECT_EQ(batches_.lanes(kernel_), kMost);
  EXPECT_EQ(batches_.lanes_onwards(kernel_), kMost);
  batches_.took(kernel_, 1 << 10, 0.5);
  EXPECT_EQ(batches_.lanes_onwards(kernel_), 1u << 9);
  EXPECT_EQ(batches_.lanes({&kernel_, nullptr}), 1u << 9);
}

TEST_F(BatchSizes, AreAtLeastAWorkgroupAndAtMostTheRoom) {
  longest(1, 10);
  EXPECT_EQ(batches_.lanes(kernel_), 64u);
  EXPECT_EQ(Batches(100).lanes(kernel_), 100u);
  EXPECT_EQ(Batches(100, 1000).lanes(kernel_), 100u);
}

}  // namespace
}  // namespace capcon
