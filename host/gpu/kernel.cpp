#include "gpu/kernel.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "gpu/check.h"

namespace capcon::gpu {
namespace {

VkDescriptorType type_of(Access access) {
  return access == Access::texels ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
                                  : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

VkDescriptorSetLayout make_set_layout(const Device& device, const std::map<std::uint32_t, Access>& bindings) {
  std::vector<VkDescriptorSetLayoutBinding> list;
  for (const auto& [number, access] : bindings) {
    list.push_back({number, type_of(access), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  }
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = static_cast<std::uint32_t>(list.size());
  info.pBindings = list.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout),
        "create a descriptor set layout");
  return layout;
}

VkDescriptorPool make_pool(const Device& device, const std::map<std::uint32_t, Access>& bindings) {
  const auto count = static_cast<std::uint32_t>(bindings.size());
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER, count},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count}};
  VkDescriptorPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  info.maxSets = 1;
  info.poolSizeCount = 2;
  info.pPoolSizes = sizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device.handle(), &info, nullptr, &pool), "create a descriptor pool");
  return pool;
}

VkPipelineLayout make_layout(const Device& device, VkDescriptorSetLayout set, std::uint32_t push_bytes) {
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = push_bytes > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout), "create a pipeline layout");
  return layout;
}

VkPipeline make_pipeline(const Device& device, VkPipelineLayout layout, std::span<const std::uint32_t> spirv,
                         const std::map<std::uint32_t, std::uint32_t>& constants) {
  VkShaderModuleCreateInfo module_info{};
  module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  module_info.codeSize = spirv.size_bytes();
  module_info.pCode = spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device.handle(), &module_info, nullptr, &module), "load a kernel");
  std::vector<VkSpecializationMapEntry> entries;
  std::vector<std::uint32_t> values;
  for (const auto& [id, value] : constants) {
    entries.push_back({id, static_cast<std::uint32_t>(4 * values.size()), 4});
    values.push_back(value);
  }
  const VkSpecializationInfo specialisation{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                            4 * values.size(), values.data()};
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &specialisation;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result =
      vkCreateComputePipelines(device.handle(), device.pipeline_cache(), 1, &info, nullptr, &pipeline);
  vkDestroyShaderModule(device.handle(), module, nullptr);
  check(result, "compile a kernel");
  return pipeline;
}

}  // namespace

Kernel::Kernel(const Device& device, std::span<const std::uint32_t> spirv,
               const std::map<std::uint32_t, Access>& bindings,
               const std::map<std::uint32_t, std::uint32_t>& constants, std::uint32_t push_bytes)
    : device_(&device), bindings_(bindings), push_bytes_(push_bytes) {
  for (const Access access : {Access::texels, Access::storage}) {
    const auto count =
        std::count_if(bindings.begin(), bindings.end(), [&](const auto& b) { return b.second == access; });
    const std::uint32_t most = device.description().max_bindings;
    if (count > most)
      throw Failure(
          fmt::format("{} binds at most {} buffers to a kernel, and {} are needed; try another --device",
                      device.description().name, most, count));
  }
  try {
    set_layout_ = make_set_layout(device, bindings);
    pool_ = make_pool(device, bindings);
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool_;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &set_layout_;
    check(vkAllocateDescriptorSets(device.handle(), &info, &descriptors_), "allocate a descriptor set");
    layout_ = make_layout(device, set_layout_, push_bytes);
    pipeline_ = make_pipeline(device, layout_, spirv, constants);
  } catch (...) {
    destroy();
    throw;
  }
}

Kernel::~Kernel() {
  destroy();
}

void Kernel::destroy() noexcept {
  vkDestroyPipeline(device_->handle(), pipeline_, nullptr);
  vkDestroyPipelineLayout(device_->handle(), layout_, nullptr);
  vkDestroyDescriptorPool(device_->handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_->handle(), set_layout_, nullptr);
}

void Kernel::bind(std::uint32_t binding, const Buffer& buffer) {
  const auto found = bindings_.find(binding);
  if (found == bindings_.end()) return;  // left out of this kernel
  const DeviceDescription& limits = device_->description();
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = descriptors_;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type_of(found->second);
  const VkDescriptorBufferInfo info{buffer.handle(), 0, VK_WHOLE_SIZE};
  const VkBufferView view = buffer.texels();
  if (found->second == Access::texels) {
    if (view == VK_NULL_HANDLE) {
      throw Failure(fmt::format(
          "{} binds at most {} texels, and {} are needed; try a smaller scene or another --device",
          limits.name, limits.max_texels, buffer.bytes() / 16));
    }
    write.pTexelBufferView = &view;
  } else {
    if (buffer.bytes() > limits.max_storage_bytes) {
      throw Failure(
          fmt::format("{} binds at most {} bytes of storage, and {} are needed; try a smaller scene or "
                      "image, or another --device",
                      limits.name, limits.max_storage_bytes, buffer.bytes()));
    }
    write.pBufferInfo = &info;
  }
  vkUpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
}

}  // namespace capcon::gpu
