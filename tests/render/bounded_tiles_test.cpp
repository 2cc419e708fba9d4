#include <gtest/gtest.h>

#include "render/renderer.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

// capcon-bounded is not among sampler_names(), which sample_points_test.cpp goes through: 2 x 2 tiles to 12 x
// 12, whole, in parts by labels and in others.
TEST(SamplePoints, OfBoundedTilesAgreeToTheBit) {
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  for (const char* fetch : {"texel", "storage"}) {
    Renderer renderer(scene, {.device = "lavapipe", .fetch = fetch, .validate = true});
    for (const auto& [count, parts] :
         {std::pair{64u, 1u}, {64u, 4u}, {64u, 64u}, {144u, 1u}, {144u, 9u}, {1024u, 1u}, {2304u, 16u}}) {
      const auto sampler = make_sampler("capcon-bounded", count, 42, parts);
      const std::uint32_t pixels = count > 1000 ? 3 : 12;
      for (const std::uint32_t dimension : {0u, 1u, 3u}) {
        const auto points = renderer.sample_points(*sampler, pixels, dimension, SampleDomain::disk);
        std::size_t different = 0;
        for (std::uint32_t k = 0; k < points.size(); ++k)
          different +=
              points[k] != sampler->sample(k / count, k % count, dimension, SampleDomain::disk) ? 1 : 0;
        EXPECT_EQ(points.size(), std::size_t(pixels) * count);
        EXPECT_EQ(different, 0u) << fetch << " " << count << " in " << parts << " dimension " << dimension;
      }
    }
  }
}

}  // namespace
}  // namespace capcon
