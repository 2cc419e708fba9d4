#include "study/noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fake_device.h"
#include "folder.h"
#include "study/coarse.h"

namespace capcon {
namespace {

constexpr int kWidth = 64, kHeight = 48;

/// What image number `seed` adds to `base`, pixel by pixel.
template <typename Error>
std::vector<Image> images_with(int seeds, const Image& base, const Error& error) {
  std::vector<Image> images;
  for (int seed = 0; seed < seeds; ++seed) {
    images.push_back(base);
    for (int y = 0; y < base.height; ++y) {
      for (int x = 0; x < base.width; ++x) {
        for (int c = 0; c < base.channels; ++c)
          images.back().at(x, y, c) += static_cast<float>(error(seed, x, y));
      }
    }
  }
  return images;
}

ReferenceImage flat_reference() {
  ReferenceImage reference{Image(kWidth, kHeight, 3), 0, 0};
  for (float& v : reference.image.pixels) v = 0.5f;
  return reference;
}

double sign_of(int seed, std::uint64_t at) {
  return uniform64(7, static_cast<std::uint64_t>(seed), at) < 0.5 ? -1 : 1;
}

TEST(Coarse, ConstantErrorStaysAndCheckersGo) {
  const Image zero(kWidth, kHeight, 1);
  const auto constant = images_with(1, zero, [](int, int, int) { return 0.25; });
  EXPECT_NEAR(coarse_mse(constant[0], zero), 0.0625, 1e-9);
  const auto checkers = images_with(1, zero, [](int, int x, int y) { return (x + y) % 2 ? 1.0 : -1.0; });
  EXPECT_NEAR(coarse_mse(checkers[0], zero), 0, 1e-12);
  // Columns 0 to 3 of every block: its mean is a half.
  const auto stripes = images_with(1, zero, [](int, int x, int) { return x % 8 < 4 ? 1.0 : 0.0; });
  EXPECT_NEAR(coarse_mse(stripes[0], zero), 0.25, 1e-9);
}

TEST(Coarse, BlocksAtTheEdgeWeighAsManyPixelsAsTheyHave) {
  const Image zero(10, 9, 1);  // blocks of 8 and 2 columns, of 8 and 1 rows
  const auto corner = images_with(1, zero, [](int, int x, int y) { return x >= 8 && y >= 8 ? 1.0 : 0.0; });
  EXPECT_EQ(block_means(corner[0]).width, 2);
  EXPECT_EQ(block_means(corner[0]).at(1, 1, 0), 1);
  EXPECT_NEAR(coarse_mse(corner[0], zero), 2.0 / 90, 1e-12);
}

TEST(Noise, OpposedErrorsByHand) {
  // +a, -a: the mean is the reference, the variance 2 a^2.
  const ReferenceImage reference = flat_reference();
  const auto images = images_with(2, reference.image, [](int seed, int, int) { return seed ? -0.25 : 0.25; });
  const NoiseCell cell = noise_of(images, reference);
  EXPECT_NEAR(cell.deviation.value, 0.25 * std::sqrt(2.0), 1e-7);
  EXPECT_NEAR(cell.mean_error, 0, 1e-7);
  EXPECT_NEAR(cell.chance, 0.25, 1e-7);
  EXPECT_NEAR(cell.bias_square.value, -0.0625, 1e-7);
  EXPECT_NEAR(cell.coarse.value, 1, 1e-9);
  const NoiseMap map = noise_map(images, reference.image);
  EXPECT_NEAR(map.deviation.at(3, 5, 0), 0.25 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(map.mean_error.at(3, 5, 0), 0, 1e-6);
}

TEST(Noise, TellsIndependentErrorsFromABias) {
  const ReferenceImage reference = flat_reference();
  const auto noise = [](int seed, int x, int y) { return 0.1 * sign_of(seed, y * kWidth + x); };
  const NoiseCell fair = noise_of(images_with(8, reference.image, noise), reference);
  EXPECT_NEAR(fair.deviation.value, 0.1, 1e-3);
  EXPECT_NEAR(fair.mean_error / fair.chance, 1, 0.03);
  EXPECT_FALSE(fair.bias_square.above(0));
  EXPECT_NEAR(fair.coarse.value, 1.0 / 64, 0.1 / 64 * 2);  // 8 x 48 blocks, the same in all channels
  const auto biased = [&](int seed, int x, int y) { return noise(seed, x, y) + 0.05; };
  const NoiseCell off = noise_of(images_with(8, reference.image, biased), reference);
  EXPECT_NEAR(off.deviation.value, 0.1, 1e-3);
  EXPECT_NEAR(off.bias_square.value, 0.0025, 2e-4);
  EXPECT_TRUE(off.bias_square.above(0));
  EXPECT_NEAR(off.coarse.value, (0.01 / 64 + 0.0025) / 0.0125, 0.02);
}

TEST(Noise, BlotchesAreCoarseAndNoBias) {
  const ReferenceImage reference = flat_reference();
  const auto blotches = [](int seed, int x, int y) { return 0.1 * sign_of(seed, y / 8 * 100 + x / 8); };
  const NoiseCell cell = noise_of(images_with(8, reference.image, blotches), reference);
  EXPECT_NEAR(cell.coarse.value, 1, 1e-6);
  EXPECT_FALSE(cell.bias_square.above(0));
}

TEST(Noise, TheReferencesErrorIsTakenOff) {
  ReferenceImage reference = flat_reference();
  reference.error = 0.0004;
  reference.coarse_error = 0.0004;
  // The reference itself is 0.02 too high everywhere: no bias of the sampler.
  const auto images =
      images_with(4, reference.image, [](int seed, int, int) { return -0.02 + (seed % 2 ? 0.1 : -0.1); });
  const NoiseCell cell = noise_of(images, reference);
  EXPECT_NEAR(cell.mean_error, 0.02, 1e-6);
  EXPECT_NEAR(cell.chance * cell.chance, 0.04 / 3 / 4 + 0.0004, 1e-6);
  EXPECT_NEAR(cell.coarse_mse[0], 0.12 * 0.12 - 0.0004, 1e-6);
}

TEST(Noise, CoarseRatioOfOneFactor) {
  NoiseCell a, b;
  a.coarse_mse = {1, 2, 4};
  b.coarse_mse = {2, 4, 8};
  EXPECT_NEAR(coarse_ratio(a, b).value, 0.5, 1e-12);
  EXPECT_NEAR(coarse_ratio(a, b).high, 0.5, 1e-12);
  b.coarse_mse[1] = -1;
  EXPECT_TRUE(std::isnan(coarse_ratio(a, b).value));
}

TEST(RunImages, OfOtherSettingsAreMissing) {
  const Folder folder;
  const PlannedRun run{"capcon", 4, 2};
  const Image image = flat_reference().image;
  run_images(folder, "a").write(run, image);
  const auto same = run_images(folder, "a").read(run);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->pixels, image.pixels);
  EXPECT_FALSE(run_images(folder, "b").read(run));
  EXPECT_FALSE(run_images(folder, "a").read({"capcon", 4, 3}));
}

}  // namespace
}  // namespace capcon
