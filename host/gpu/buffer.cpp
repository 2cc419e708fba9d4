#include "gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "gpu/check.h"
#include "gpu/commands.h"

namespace capcon::gpu {
namespace {

OutOfMemory no_room(const Device& device, std::uint64_t bytes, std::uint64_t in_use, const char* reason) {
  const auto mebibytes = [](std::uint64_t b) { return static_cast<double>(b) / (1 << 20); };
  return OutOfMemory(
      fmt::format("{} has no room for a buffer of {:.1f} MiB beside the {:.1f} of {:.1f} MiB in use ({}); "
                  "try a smaller scene or image, "
                  "--instancing two-level, or another --device",
                  device.description().name, mebibytes(bytes), mebibytes(in_use),
                  mebibytes(device.description().memory_bytes), reason));
}

}  // namespace

Buffer::Buffer(const Device& device, std::size_t bytes, Memory memory)
    : device_(&device), bytes_(std::max<std::size_t>((bytes + 15) / 16 * 16, 16)) {
  try {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes_;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT |
                 VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    // Drivers on the CPU hand out more than they say they have, until the system ends the program.
    const std::uint64_t in_use = device.take_memory(bytes_);
    if (in_use + bytes_ > device.description().memory_bytes)
      throw no_room(device, bytes_, in_use, "all of its memory is taken");
    const VkResult created = vkCreateBuffer(device.handle(), &info, nullptr, &handle_);
    if (created < 0) throw no_room(device, bytes_, in_use, result_name(created));
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.handle(), handle_, &needs);
    const VkMemoryPropertyFlags visible =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex =
        memory == Memory::host
            ? device.memory_type(needs.memoryTypeBits, visible, VK_MEMORY_PROPERTY_HOST_CACHED_BIT)
            : device.memory_type(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
                                 device.is_cpu() ? visible : 0);
    const VkResult result = vkAllocateMemory(device.handle(), &allocation, nullptr, &memory_);
    if (result < 0) throw no_room(device, bytes_, in_use, result_name(result));
    check(vkBindBufferMemory(device.handle(), handle_, memory_, 0), "bind memory");
    if (memory == Memory::host || device.is_cpu()) {
      check(vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "map memory");
    }
    if (bytes_ / 16 <= device.description().max_texels) {
      VkBufferViewCreateInfo view{};
      view.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
      view.buffer = handle_;
      view.format = VK_FORMAT_R32G32B32A32_UINT;
      view.range = VK_WHOLE_SIZE;
      check(vkCreateBufferView(device.handle(), &view, nullptr, &view_), "create a texel view");
    }
  } catch (...) {
    Buffer dropped;
    swap(dropped);
    throw;
  }
}

Buffer::~Buffer() {
  if (!device_) return;
  device_->give_memory(bytes_);
  vkDestroyBufferView(device_->handle(), view_, nullptr);
  vkDestroyBuffer(device_->handle(), handle_, nullptr);
  vkFreeMemory(device_->handle(), memory_, nullptr);
}

void Buffer::swap(Buffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(handle_, other.handle_);
  std::swap(memory_, other.memory_);
  std::swap(view_, other.view_);
  std::swap(bytes_, other.bytes_);
  std::swap(mapped_, other.mapped_);
}

void Buffer::upload(const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  if (mapped_) {
    std::memcpy(mapped_, data, bytes);
    return;
  }
  Buffer staging(*device_, bytes, Memory::host);
  staging.upload(data, bytes);
  copy_from(staging, bytes);
}

void Buffer::download(void* data, std::size_t bytes) const {
  if (bytes == 0) return;
  if (mapped_) {
    std::memcpy(data, mapped_, bytes);
    return;
  }
  const Buffer staging(*device_, bytes, Memory::host);
  staging.copy_from(*this, bytes);
  staging.download(data, bytes);
}

void Buffer::clear() {
  if (mapped_) {
    std::memset(mapped_, 0, bytes_);
    return;
  }
  Commands commands(*device_);
  vkCmdFillBuffer(commands.handle(), handle_, 0, VK_WHOLE_SIZE, 0);
  commands.submit_and_wait();
}

void Buffer::copy_from(const Buffer& source, std::size_t bytes) const {
  Commands commands(*device_);
  const VkBufferCopy region{0, 0, bytes};
  vkCmdCopyBuffer(commands.handle(), source.handle_, handle_, 1, &region);
  commands.submit_and_wait();
}

}  // namespace capcon::gpu
