#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/kernel.h"

namespace capcon::gpu {

/// Commands recorded once, submitted once, waited for. Dispatches run in order; each sees what those before
/// it wrote.
class Commands {
 public:
  explicit Commands(const Device& device);
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;
  ~Commands();

  VkCommandBuffer handle() const { return buffer_; }

  /// Records `groups` workgroups (1 ... 65,535) of the kernel, timed under `stage`. At most kMaxDispatches a
  /// recording.
  void dispatch(const Kernel& kernel, const void* push_constants, std::uint32_t groups,
                const std::string& stage);
  static constexpr std::uint32_t kMaxDispatches = 64;

  void submit_and_wait();

  struct Time {
    std::string stage;
    double seconds;
  };
  /// Device seconds of each dispatch, by the device's own timestamps; after submit_and_wait.
  const std::vector<Time>& times() const { return times_; }

 private:
  void destroy() noexcept;

  const Device* device_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  VkQueryPool queries_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  bool running_ = false;  ///< submitted, and not known to be done
  std::vector<Time> times_;
};

}  // namespace capcon::gpu
