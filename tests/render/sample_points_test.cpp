#include <gtest/gtest.h>

#include "layout.h"
#include "render/renderer.h"
#include "render/small_scenes.h"
#include "sampling/choice.h"

namespace capcon {
namespace {

// The shader's samplers give the host's bits, for every sampler, kind of count and of split, and dimension
// pair.
TEST(SamplePoints, DeviceAndHostAgreeToTheBit) {
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  for (const char* fetch : {"texel", "storage"}) {
    Renderer renderer(scene, {.device = "lavapipe", .fetch = fetch, .validate = true});
    for (const std::string& name : sampler_names()) {
      for (std::uint32_t count : {1u, 2u, 7u, 12u, 16u, 17u, 32u, 50u, 64u, 100u, 128u, 2400u}) {
        if ((name == "ccvt" || name == "fpo" || name.starts_with("capcon-")) && count > 128) continue;
        const std::uint32_t cut = count % 4 == 0 ? 4 : count % 5 == 0 ? 5 : 1;
        for (const std::uint32_t parts :
             {1u, cut, count == 16 || (count >= 64 && count % 16 == 0) ? 16u : 1u}) {
          if (parts == 1 && cut > 1 && std::string(fetch) == "storage") continue;  // time
          const auto sampler = make_sampler(name, count, 42, parts);
          const std::uint32_t pixels = count > 1000 ? 3 : 12;
          for (std::uint32_t dimension : {0u, 1u, 3u}) {
            const SampleDomain domain = dimension == 0   ? SampleDomain::disk
                                        : dimension == 1 ? SampleDomain::square
                                                         : SampleDomain::cylinder;
            const auto points = renderer.sample_points(*sampler, pixels, dimension, domain);
            std::size_t different = 0;
            for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
              for (std::uint32_t i = 0; i < count; ++i) {
                if (points[std::size_t(pixel) * count + i] != sampler->sample(pixel, i, dimension, domain))
                  ++different;
              }
            }
            EXPECT_EQ(different, 0u) << fetch << " " << name << " count " << count << " in " << parts
                                     << " dimension " << dimension;
          }
        }
      }
    }
  }
}

// Those that know a pixel's neighbours, in an image 5 pixels wide.
TEST(SamplePoints, SetsOfTheScreenAgreeToTheBit) {
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  Renderer renderer(scene, {.device = "lavapipe", .validate = true});
  for (const char* name : {"sobol-z", "capcon-screen"}) {
    for (const std::uint32_t parts : {1u, 2u}) {
      const auto sampler = make_sampler(name, 4, 5, parts, 5);
      for (const auto domain : {SampleDomain::square, SampleDomain::disk, SampleDomain::cylinder}) {
        const auto points = renderer.sample_points(*sampler, 400, 1, domain);
        std::size_t different = 0;
        for (std::uint32_t k = 0; k < points.size(); ++k)
          different += points[k] != sampler->sample(k / 4, k % 4, 1, domain) ? 1 : 0;
        EXPECT_EQ(points.size(), 1600u);
        EXPECT_EQ(different, 0u) << name << " " << parts << " " << int(domain);
      }
    }
  }
}

// As many as light paths take: tables of a hundred thousand texels.
TEST(SamplePoints, SetsOfLightPathsAgreeToTheBit) {
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  Renderer renderer(scene, {.device = "lavapipe", .validate = true});
  for (const auto& [name, count, parts] : {std::tuple("fpo", 1152u, 9u),
                                           {"halton", 1152u, 9u},
                                           {"capcon-domain", 1152u, 9u},
                                           {"capcon-ranked", 1024u, 8u}}) {
    const auto sampler = make_sampler(name, count, 5, parts);
    const auto points = renderer.sample_points(*sampler, 2, 1, SampleDomain::disk);
    std::size_t different = 0;
    for (std::uint32_t k = 0; k < points.size(); ++k)
      different += points[k] != sampler->sample(k / count, k % count, 1, SampleDomain::disk) ? 1 : 0;
    EXPECT_EQ(points.size(), 2u * count) << name;
    EXPECT_EQ(different, 0u) << name;
  }
}

TEST(SamplePoints, ChoicesOfComponentsAgreeToTheBit) {
  const Scene scene = testing::random_soup(3, 1, 4, 4);
  Renderer renderer(scene, {.device = "lavapipe", .validate = true});
  for (const auto& [count, parts] :
       {std::pair(1u, 1u), {16u, 1u}, {16u, 4u}, {16u, 16u}, {35u, 5u}, {400u, 1u}}) {
    const auto sampler = make_sampler("random", count, 9, parts);
    for (const bool separate : {false, true}) {
      const auto points = renderer.sample_points(*sampler, 30, layout::kPairComponent,
                                                 separate ? SampleDomain::disk : SampleDomain::square);
      for (std::uint32_t pixel = 0; pixel < 30; ++pixel) {
        for (std::uint32_t i = 0; i < count; ++i) {
          const Split& split = sampler->split();
          ASSERT_EQ(points[pixel * count + i].x,
                    component_choice(9, pixel, i / split.points, i % split.points, split, separate))
              << count << " " << parts << " " << pixel << " " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace capcon
