#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "gpu/device.h"

namespace capcon::gpu {

/// Where a buffer lives and who reads it.
enum class Memory {
  device,  ///< fast for kernels; filled through a staging buffer unless the host can write there itself
  host     ///< mapped: results that the host reads
};

/// A buffer with its memory, usable as storage and as texels of four 32-bit words (rgba32ui) where the size
/// fits the device's texel limit. Empty buffers get 16 bytes, so that they can be bound. OutOfMemory
/// (gpu/check.h) where there is no room.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Device& device, std::size_t bytes, Memory memory);
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer();

  VkBuffer handle() const { return handle_; }
  VkBufferView texels() const { return view_; }
  std::size_t bytes() const { return bytes_; }

  void upload(const void* data, std::size_t bytes);
  void download(void* data, std::size_t bytes) const;
  /// Sets every byte to zero.
  void clear();

 private:
  void swap(Buffer& other) noexcept;
  void copy_from(const Buffer& source, std::size_t bytes) const;

  const Device* device_ = nullptr;
  VkBuffer handle_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkBufferView view_ = VK_NULL_HANDLE;
  std::size_t bytes_ = 0;
  void* mapped_ = nullptr;
};

/// A device buffer that holds `data`.
template <class T>
Buffer make_buffer(const Device& device, std::span<const T> data) {
  Buffer buffer(device, data.size_bytes(), Memory::device);
  buffer.upload(data.data(), data.size_bytes());
  return buffer;
}

}  // namespace capcon::gpu
