#include "gpu/pipeline_cache.h"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "base/cache.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/sealed.h"
#include "gpu/check.h"

namespace capcon::gpu {
namespace {

// Vulkan checks vendor, device and cache UUID in the data's own header, but not that the rest is whole: that
// is what the seal is for.
constexpr std::string_view kMagic = "capcon pipelines 1";

}  // namespace

PipelineCache::PipelineCache(VkDevice device, const DeviceDescription& description) : device_(device) {
  const std::filesystem::path folder = cache_folder();
  if (!folder.empty()) {
    path_ =
        folder / fmt::format("pipelines-{:016x}.bin", fnv1a64(description.name + "\n" + description.driver));
    std::error_code error;
    if (std::filesystem::is_regular_file(path_, error)) {
      try {
        loaded_ = unsealed(kMagic, read_file(path_)).value_or("");
      } catch (const std::exception&) {
      }
    }
  }
  VkPipelineCacheCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
  info.initialDataSize = loaded_.size();
  info.pInitialData = loaded_.data();
  check(vkCreatePipelineCache(device, &info, nullptr, &handle_), "create a pipeline cache");
}

PipelineCache::~PipelineCache() {
  std::size_t bytes = 0;
  if (!path_.empty() && vkGetPipelineCacheData(device_, handle_, &bytes, nullptr) == VK_SUCCESS &&
      bytes > 0) {
    std::string data(bytes, '\0');
    try {
      if (vkGetPipelineCacheData(device_, handle_, &bytes, data.data()) == VK_SUCCESS && data != loaded_) {
        std::filesystem::create_directories(path_.parent_path());
        write_file(path_, sealed(kMagic, data));
      }
    } catch (const std::exception&) {
    }
  }
  vkDestroyPipelineCache(device_, handle_, nullptr);
}

}  // namespace capcon::gpu
