#include "sampling/point_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/hash.h"
#include "points/point_set.h"
#include "render/renderer.h"
#include "render/small_scenes.h"

namespace capcon {
namespace {

// A user's sets on the device: the host's bits, for one set and several, however they are randomised and cut.
TEST(PointFileOnTheDevice, GivesTheHostsBits) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("capcon_sets_" + std::to_string(::getpid()) + ".txt");
  for (const std::uint32_t sets : {1u, 3u}) {
    std::vector<Points> all(sets);
    for (std::uint32_t s = 0; s < sets; ++s) {
      for (std::uint32_t i = 0; i < 36; ++i)
        all[s].emplace_back(uniform64(1, s, 2 * i), uniform64(1, s, 2 * i + 1));
    }
    write_points(path, all);
    Renderer renderer(testing::random_soup(3, 1, 4, 4), {.device = "lavapipe", .validate = true});
    for (const char* words : {"", ":xor", ":none", ":sequence"}) {
      if (sets == 1 && std::string(words) == ":none") continue;
      for (const auto& [count, parts] : {std::pair(36u, 4u), {35u, 1u}, {7u, 7u}}) {
        const auto sampler = make_sampler("file:" + path.string() + words, count, 42, parts);
        for (const std::uint32_t dimension : {0u, 3u}) {
          const auto points = renderer.sample_points(*sampler, 20, dimension, SampleDomain::square);
          std::size_t different = 0;
          for (std::uint32_t k = 0; k < points.size(); ++k)
            different += points[k] != sampler->sample(k / count, k % count, dimension) ? 1 : 0;
          EXPECT_EQ(different, 0u) << sets << " sets" << words << ", " << count << " in " << parts;
          EXPECT_EQ(points.size(), 20u * count);
        }
      }
    }
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace capcon
