#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "base/cache.h"
#include "base/error.h"
#include "base/file.h"
#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/kernel.h"
#include "gpu/pipeline_cache.h"
#include "spirv/points_storage.h"
#include "spirv/points_texel.h"

namespace capcon::gpu {
namespace {

class Limits : public ::testing::Test {
 protected:
  Instance instance{true};
  Device device{instance, instance.choose("lavapipe")};

  /// The sentence of the failure.
  static std::string failure(const std::function<void()>& act) {
    try {
      act();
    } catch (const Failure& error) {
      return error.what();
    }
    return "no failure";
  }
};

// lavapipe binds 128 MiB of storage at most: more is refused in words, and read as texels.
TEST_F(Limits, LargeBuffersAreTexelsOrRefused) {
  const Buffer buffer(device, (std::size_t(129) << 20), Memory::device);
  Kernel storage(device, k_points_storage_spirv, {{3, Access::storage}, {6, Access::storage}}, {}, 112);
  Kernel texels(device, k_points_texel_spirv, {{3, Access::texels}, {6, Access::storage}}, {}, 112);
  const std::string refused = failure([&] { storage.bind(3, buffer); });
  EXPECT_NE(refused.find("binds at most 134217728 bytes of storage, and 135266304 are needed"),
            std::string::npos)
      << refused;
  EXPECT_NO_THROW(texels.bind(3, buffer));
  EXPECT_EQ(instance.message_count(), 0);
}

TEST_F(Limits, MoreThanTheDeviceHasIsSaidWithItsSize) {
  const std::string full = failure([&] { Buffer(device, std::size_t(1) << 50, Memory::device); });
  EXPECT_NE(full.find("has no room for a buffer of 1073741824.0 MiB beside the 0.0 of "), std::string::npos)
      << full;
  EXPECT_NE(full.find("try a smaller scene or image"), std::string::npos) << full;
}

/// The environment variable while this lives.
class CacheHome {
 public:
  explicit CacheHome(const std::filesystem::path& folder) {
    if (const char* old = std::getenv("XDG_CACHE_HOME")) old_ = old;
    ::setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  }
  ~CacheHome() {
    if (old_.empty()) {
      ::unsetenv("XDG_CACHE_HOME");
    } else {
      ::setenv("XDG_CACHE_HOME", old_.c_str(), 1);
    }
  }

 private:
  std::string old_;
};

TEST_F(Limits, PipelineCacheIsKeptAndABrokenOneIsIgnored) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "capcon-pipelines";
  std::filesystem::remove_all(folder);
  const CacheHome home(folder);
  EXPECT_EQ(cache_folder(), folder / "capcon");
  const auto compile = [&] {
    const Device fresh(instance, instance.choose("lavapipe"));
    Kernel(fresh, k_points_storage_spirv, {{3, Access::storage}, {6, Access::storage}}, {}, 112);
  };
  compile();
  ASSERT_TRUE(std::filesystem::exists(folder / "capcon"));
  const auto file = std::filesystem::directory_iterator(folder / "capcon")->path();
  const std::string kept = read_file(file);
  EXPECT_EQ(kept.rfind("capcon pipelines 1 ", 0), 0u);
  std::ofstream(file, std::ios::binary) << kept.substr(0, kept.size() - 1);
  EXPECT_NO_THROW(compile());
  EXPECT_EQ(read_file(file), kept) << "written anew";
  std::filesystem::remove_all(folder);
  std::ofstream(folder) << "not a folder";
  EXPECT_NO_THROW(compile());
  std::filesystem::remove(folder);
  EXPECT_EQ(instance.message_count(), 0);
}

}  // namespace
}  // namespace capcon::gpu
