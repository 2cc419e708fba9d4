// Shares of a job's samples, rendered apart and added up, are the image of the whole job.
#include "render/lit_rooms.h"

namespace capcon {
namespace {

using namespace testing;

RenderResult add_up(Renderer& renderer, const Job& job, std::uint32_t shares) {
  RenderResult all;
  std::uint64_t rays = 0;
  for (std::uint32_t i = 0; i < shares; ++i) {
    RenderResult part = renderer.render(with_share(job, {i, shares}));
    rays += part.rays;
    if (i == 0) {
      all = std::move(part);
      continue;
    }
    for (std::size_t k = 0; k < all.sums.size(); ++k) all.sums[k] += part.sums.at(k);
  }
  all.rays = rays;
  finish_shares(all);
  return all;
}

void expect_whole(const std::string& what, Renderer& renderer, const Job& job, float tolerance) {
  const RenderResult whole = renderer.render(job);
  for (const std::uint32_t shares : {3u, 7u}) {
    const RenderResult all = add_up(renderer, job, shares);
    float most = 0;
    for (std::size_t i = 0; i < whole.image.pixels.size(); ++i) {
      const float scale = std::max(1e-3f, whole.image.pixels[i]);
      most = std::max(most, std::abs(all.image.pixels[i] - whole.image.pixels[i]) / scale);
    }
    EXPECT_LE(most, tolerance) << what << ", " << shares << " shares";
    // Light paths are traced for each share.
    if (!std::holds_alternative<GlobalIlluminationJob>(job)) {
      EXPECT_EQ(all.rays, whole.rays) << what;
    }
  }
}

TEST(Shares, AreConsecutiveAndComplete) {
  for (const std::uint32_t n : {1u, 5u, 16u, 1u << 24}) {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < 6; ++i) {
      const auto [first, end] = SampleShare{i, 6}.of(n);
      EXPECT_EQ(first, next);
      EXPECT_LE(end - first, n / 6 + 1);
      next = end;
    }
    EXPECT_EQ(next, n);
  }
}

/// One scene on the device for all.
class SharesOf : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { renderer_ = new Renderer(furnished_corner(), lavapipe()); }
  static void TearDownTestSuite() { delete renderer_; }
  static inline Renderer* renderer_ = nullptr;
};

// Counts of rays are whole numbers: not a bit differs.
TEST_F(SharesOf, AmbientOcclusion) {
  expect_whole("ordered", *renderer_, AmbientOcclusionJob{1, "sobol-owen", 16, 3}, 0);
  expect_whole("jittered", *renderer_, AmbientOcclusionJob{1, "capcon", 5, 3, PixelPosition::jittered}, 0);
}

TEST_F(SharesOf, DirectLighting) {
  DirectLightingJob job = room_job().direct;
  job.image_samples = 5;
  job.integrator_samples = 4;
  expect_whole("centre", *renderer_, job, 1e-6f);
  job.partition = false;
  job.position = PixelPosition::jittered;
  expect_whole("jittered", *renderer_, job, 1e-6f);
}

TEST_F(SharesOf, GlobalIllumination) {
  GlobalIlluminationJob job = room_job();
  job.paths = 8;
  job.sets = 4;
  expect_whole("centre", *renderer_, job, 1e-5f);
  job.direct.position = PixelPosition::jittered;
  job.direct.image_samples = 4;
  expect_whole("jittered", *renderer_, job, 1e-5f);
}

}  // namespace
}  // namespace capcon
