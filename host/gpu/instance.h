#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace capcon::gpu {

/// What `capcon info` lists of a device.
struct DeviceDescription {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  std::string name;
  std::string driver;       ///< driver name and version text
  std::string api_version;  ///< "1.3.230"
  std::string kind;         ///< discrete, integrated, virtual, cpu, other
  std::uint32_t subgroup_size = 0;
  std::uint64_t memory_bytes = 0;       ///< largest device-local heap
  std::uint64_t max_storage_bytes = 0;  ///< of one storage buffer binding
  std::uint64_t max_texels = 0;         ///< of one texel buffer
  std::uint32_t max_bindings = 0;  ///< storage buffers, and as many texel buffers, that a kernel can have
  std::string lacks;               ///< what the kernels need and it does not have; empty: usable
  bool usable() const { return lacks.empty(); }
};

/// The Vulkan instance, with the validation layer and its synchronisation validation on request. Failure when
/// there is no Vulkan loader or driver at all.
class Instance {
 public:
  explicit Instance(bool validate);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance();

  VkInstance handle() const { return handle_; }
  bool validates() const { return messenger_ != VK_NULL_HANDLE; }

  /// All devices, best first: discrete, integrated, virtual, CPU; among equals the more memory.
  std::vector<DeviceDescription> devices() const;
  /// "best", "lavapipe", a number of the list, or part of a name. InputError when nothing fits, Failure when
  /// there is none, or none that can be used.
  DeviceDescription choose(const std::string& selector) const;

  /// Messages of the validation layer so far (each is also printed to stderr).
  int message_count() const { return *message_count_; }

 private:
  VkInstance handle_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::unique_ptr<std::atomic<int>> message_count_ = std::make_unique<std::atomic<int>>(0);
};

}  // namespace capcon::gpu
