#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "gpu/buffer.h"

namespace capcon::gpu {

enum class Access {
  texels,  ///< a storage texel buffer of rgba32ui
  storage  ///< a storage buffer
};

/// One compute pipeline with its own descriptor set.
class Kernel {
 public:
  /// `bindings`: number -> how the shader declares it. `constants`: specialisation constants, id -> 32-bit
  /// value.
  Kernel(const Device& device, std::span<const std::uint32_t> spirv,
         const std::map<std::uint32_t, Access>& bindings,
         const std::map<std::uint32_t, std::uint32_t>& constants, std::uint32_t push_bytes);
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  ~Kernel();

  /// Binds a buffer for the dispatches recorded from now on. Not while one that uses this kernel is running.
  /// Failure when the buffer is larger than the device can bind.
  void bind(std::uint32_t binding, const Buffer& buffer);

  VkPipeline pipeline() const { return pipeline_; }
  VkPipelineLayout layout() const { return layout_; }
  VkDescriptorSet descriptors() const { return descriptors_; }
  std::uint32_t push_bytes() const { return push_bytes_; }

 private:
  void destroy() noexcept;

  const Device* device_;
  std::map<std::uint32_t, Access> bindings_;
  std::uint32_t push_bytes_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet descriptors_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace capcon::gpu
