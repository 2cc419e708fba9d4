#include "gpu/device.h"

#include <vector>

#include "base/error.h"
#include "gpu/check.h"

namespace capcon::gpu {

Device::Device(const Instance&, const DeviceDescription& description) : description_(description) {
  const VkPhysicalDevice physical = description.handle;
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  std::uint32_t family = count;
  for (std::uint32_t f = 0; f < count && family == count; ++f) {
    if ((families[f].queueFlags & VK_QUEUE_COMPUTE_BIT) && families[f].timestampValidBits > 0) family = f;
  }
  if (family == count)
    throw Failure(description.name + " has no compute queue with timestamps; choose another --device");
  const std::uint32_t bits = families[family].timestampValidBits;
  if (bits < 64) timestamp_mask_ = (std::uint64_t(1) << bits) - 1;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  check(vkCreateDevice(physical, &info, nullptr, &handle_), "create a device");
  vkGetDeviceQueue(handle_, family, 0, &queue_);
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = family;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  timestamp_seconds_ = 1e-9 * properties.limits.timestampPeriod;
  try {
    check(vkCreateCommandPool(handle_, &pool, nullptr, &command_pool_), "create a command pool");
    pipeline_cache_ = std::make_unique<PipelineCache>(handle_, description_);
  } catch (...) {
    destroy();
    throw;
  }
}

Device::~Device() {
  destroy();
}

void Device::destroy() noexcept {
  pipeline_cache_.reset();
  vkDestroyCommandPool(handle_, command_pool_, nullptr);
  vkDestroyDevice(handle_, nullptr);
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags flags,
                                  VkMemoryPropertyFlags wished) const {
  std::uint32_t found = memory_.memoryTypeCount;
  for (std::uint32_t t = 0; t < memory_.memoryTypeCount; ++t) {
    const VkMemoryPropertyFlags has = memory_.memoryTypes[t].propertyFlags;
    if ((allowed >> t & 1u) == 0 || (has & flags) != flags) continue;
    if ((has & wished) == wished) return t;
    if (found == memory_.memoryTypeCount) found = t;
  }
  if (found == memory_.memoryTypeCount)
    throw Failure(description_.name + " has no memory of the kind that is needed");
  return found;
}

}  // namespace capcon::gpu
