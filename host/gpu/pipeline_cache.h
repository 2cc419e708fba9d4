#pragma once

#include <vulkan/vulkan.h>

#include <filesystem>

#include "gpu/instance.h"

namespace capcon::gpu {

/// Compiled pipelines kept on disk: one file a device and driver under cache_folder() (base/cache.h). A
/// missing, foreign or broken file is an empty cache, and one that cannot be written is not an error: only
/// the next start is slower.
class PipelineCache {
 public:
  PipelineCache(VkDevice device, const DeviceDescription& description);
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;
  /// Writes the file if pipelines were added.
  ~PipelineCache();

  VkPipelineCache handle() const { return handle_; }

 private:
  VkDevice device_;
  VkPipelineCache handle_ = VK_NULL_HANDLE;
  std::filesystem::path path_;  ///< empty: nowhere to keep it
  std::string loaded_;
};

}  // namespace capcon::gpu
