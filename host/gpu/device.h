#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <memory>
#include <string>

#include "gpu/instance.h"
#include "gpu/pipeline_cache.h"

namespace capcon::gpu {

/// A logical device with one compute queue. Not copyable; outlives what is made on it.
class Device {
 public:
  Device(const Instance& instance, const DeviceDescription& description);
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device();

  VkDevice handle() const { return handle_; }
  VkQueue queue() const { return queue_; }
  VkCommandPool command_pool() const { return command_pool_; }
  VkPipelineCache pipeline_cache() const { return pipeline_cache_->handle(); }
  const DeviceDescription& description() const { return description_; }
  bool is_cpu() const { return description_.kind == "cpu"; }
  /// Of two timestamps, of which the second may have wrapped around.
  double seconds_between(std::uint64_t first, std::uint64_t second) const {
    return static_cast<double>((second - first) & timestamp_mask_) * timestamp_seconds_;
  }

  /// Counts bytes of buffers that are made; returns how many were in use before.
  std::uint64_t take_memory(std::uint64_t bytes) const { return memory_in_use_.fetch_add(bytes); }
  void give_memory(std::uint64_t bytes) const { memory_in_use_.fetch_sub(bytes); }

  /// Index of a memory type in `allowed` with all of `flags`; the first that also has `wished`, if any.
  /// Failure if none.
  std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags flags,
                            VkMemoryPropertyFlags wished) const;

 private:
  void destroy() noexcept;

  DeviceDescription description_;
  VkDevice handle_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool command_pool_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  std::unique_ptr<PipelineCache> pipeline_cache_;
  double timestamp_seconds_ = 0;
  std::uint64_t timestamp_mask_ = ~std::uint64_t(0);  ///< bits that count
  mutable std::atomic<std::uint64_t> memory_in_use_{0};
};

}  // namespace capcon::gpu
