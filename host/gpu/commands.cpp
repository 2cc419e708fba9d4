#include "gpu/commands.h"

#include "gpu/check.h"

namespace capcon::gpu {

Commands::Commands(const Device& device) : device_(&device) {
  try {
    VkCommandBufferAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocation.commandPool = device.command_pool();
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device.handle(), &allocation, &buffer_), "allocate a command buffer");
    VkQueryPoolCreateInfo queries{};
    queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queries.queryCount = 2 * kMaxDispatches;
    check(vkCreateQueryPool(device.handle(), &queries, nullptr, &queries_), "create timestamps");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    check(vkCreateFence(device.handle(), &fence, nullptr, &fence_), "create a fence");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(buffer_, &begin), "record commands");
    vkCmdResetQueryPool(buffer_, queries_, 0, 2 * kMaxDispatches);
  } catch (...) {
    destroy();
    throw;
  }
}

Commands::~Commands() {
  destroy();
}

void Commands::destroy() noexcept {
  // A wait that failed for lack of memory says nothing about the work, and what is in use must not be
  // destroyed. A lost device answers at once.
  if (running_) vkDeviceWaitIdle(device_->handle());
  vkDestroyFence(device_->handle(), fence_, nullptr);
  vkDestroyQueryPool(device_->handle(), queries_, nullptr);
  if (buffer_ != VK_NULL_HANDLE)
    vkFreeCommandBuffers(device_->handle(), device_->command_pool(), 1, &buffer_);
}

void Commands::dispatch(const Kernel& kernel, const void* push_constants, std::uint32_t groups,
                        const std::string& stage) {
  const auto index = static_cast<std::uint32_t>(times_.size());
  if (index > 0) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    vkCmdPipelineBarrier(buffer_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                         0, 1, &barrier, 0, nullptr, 0, nullptr);
  }
  const VkDescriptorSet descriptors = kernel.descriptors();
  vkCmdBindPipeline(buffer_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.pipeline());
  vkCmdBindDescriptorSets(buffer_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.layout(), 0, 1, &descriptors, 0,
                          nullptr);
  if (kernel.push_bytes() > 0) {
    vkCmdPushConstants(buffer_, kernel.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, kernel.push_bytes(),
                       push_constants);
  }
  vkCmdWriteTimestamp(buffer_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_, 2 * index);
  vkCmdDispatch(buffer_, groups, 1, 1);
  vkCmdWriteTimestamp(buffer_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_, 2 * index + 1);
  times_.push_back({stage, 0});
}

void Commands::submit_and_wait() {
  VkMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(buffer_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
  check(vkEndCommandBuffer(buffer_), "record commands");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &buffer_;
  check(vkQueueSubmit(device_->queue(), 1, &submit, fence_), "submit work");
  running_ = true;
  check(vkWaitForFences(device_->handle(), 1, &fence_, VK_TRUE, UINT64_MAX), "finish the work");
  running_ = false;
  const auto count = static_cast<std::uint32_t>(times_.size());
  if (count == 0) return;
  std::vector<std::uint64_t> ticks(2 * count);
  check(vkGetQueryPoolResults(device_->handle(), queries_, 0, 2 * count, ticks.size() * 8, ticks.data(), 8,
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "read the timestamps");
  for (std::uint32_t i = 0; i < count; ++i) {
    times_[i].seconds = device_->seconds_between(ticks[2 * i], ticks[2 * i + 1]);
  }
}

}  // namespace capcon::gpu
