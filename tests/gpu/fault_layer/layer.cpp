// A Vulkan layer that fails on demand (faults.h): the tests' way to a lost device, full memory or a slow GPU,
// with the program as it is. One instance and one device at a time; calls on them come from any thread.
#include <vulkan/vk_layer.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <mutex>
#include <vector>

#include "faults.h"

namespace capcon::faults {
namespace {

constexpr std::uint64_t kGroupSize = 64;

struct State {
  std::mutex mutex;
  Faults faults = read_faults();
  VkInstance instance = VK_NULL_HANDLE;
  // Of the instance. Asked for later, the loader names the first of the chain.
  std::map<std::string, PFN_vkVoidFunction> next;
  PFN_vkGetInstanceProcAddr next_of_instance = nullptr;
  PFN_vkGetDeviceProcAddr next_of_device = nullptr;
  VkDevice device = VK_NULL_HANDLE;
  bool lost = false;
  std::uint64_t lanes = 0;                // of the commands recorded last
  std::uint64_t late = 0;                 // nanoseconds that the last submission takes on top
  std::vector<std::uint64_t> dispatches;  // their lanes
  std::uint64_t longest = 0;              // ticks of one
  ~State() {
    if (faults.log.empty()) return;
    std::ofstream file(faults.log, std::ios::app);
    for (const std::uint64_t n : dispatches) file << n << '\n';
    for (const auto& [what, count] : faults.counts) file << what << ' ' << count << '\n';
    file << "longest " << longest << '\n';
  }
};

State& state() {
  static State all;
  return all;
}

#define NEXT_INSTANCE(name) reinterpret_cast<PFN_##name>(state().next.at(#name))
#define NEXT_DEVICE(name) reinterpret_cast<PFN_##name>(state().next_of_device(state().device, #name))

VkResult fault(const char* call) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  if (s.lost) return VK_ERROR_DEVICE_LOST;
  const VkResult result = s.faults.called(call);
  if (result == VK_ERROR_DEVICE_LOST) s.lost = true;
  return result;
}

/// The link to the next layer that the loader put into the chain of a create info; moved on for that layer.
template <class Info>
Info* link_of(const void* chain, VkStructureType type) {
  for (auto* info = static_cast<Info*>(const_cast<void*>(chain)); info;
       info = static_cast<Info*>(const_cast<void*>(info->pNext))) {
    if (info->sType == type && info->function == VK_LAYER_LINK_INFO) return info;
  }
  return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator, VkInstance* instance) {
  State& s = state();
  if (const VkResult result = fault("instance"); result < 0) return result;
  auto* link = link_of<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  s.next_of_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(s.next_of_instance(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  s.instance = *instance;
  for (const char* name : {"vkEnumeratePhysicalDevices", "vkGetPhysicalDeviceProperties2",
                           "vkGetPhysicalDeviceQueueFamilyProperties", "vkGetPhysicalDeviceMemoryProperties"})
    s.next[name] = s.next_of_instance(*instance, name);
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL enumerate(VkInstance instance, std::uint32_t* count,
                                         VkPhysicalDevice* devices) {
  if (state().faults.has("no-device")) return *count = 0, VK_SUCCESS;
  return NEXT_INSTANCE(vkEnumeratePhysicalDevices)(instance, count, devices);
}

VKAPI_ATTR void VKAPI_CALL properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* p) {
  NEXT_INSTANCE(vkGetPhysicalDeviceProperties2)(device, p);
  const Faults& f = state().faults;
  VkPhysicalDeviceLimits& limits = p->properties.limits;
  if (f.has("old")) p->properties.apiVersion = VK_API_VERSION_1_1;
  if (f.has("storage")) limits.maxStorageBufferRange = static_cast<std::uint32_t>(f.value("storage"));
  if (f.has("texels")) limits.maxTexelBufferElements = static_cast<std::uint32_t>(f.value("texels"));
  if (f.has("bindings"))
    limits.maxPerStageDescriptorStorageBuffers = limits.maxPerStageDescriptorStorageImages =
        static_cast<std::uint32_t>(f.value("bindings"));
  for (auto* more = static_cast<VkBaseOutStructure*>(p->pNext); more; more = more->pNext) {
    if (f.has("no-votes") && more->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES)
      reinterpret_cast<VkPhysicalDeviceSubgroupProperties*>(more)->supportedOperations =
          VK_SUBGROUP_FEATURE_BASIC_BIT;
  }
}

VKAPI_ATTR void VKAPI_CALL queue_families(VkPhysicalDevice device, std::uint32_t* count,
                                          VkQueueFamilyProperties* families) {
  NEXT_INSTANCE(vkGetPhysicalDeviceQueueFamilyProperties)(device, count, families);
  for (std::uint32_t i = 0; families && i < *count; ++i) {
    if (state().faults.has("no-compute")) families[i].queueFlags &= ~VkQueueFlags(VK_QUEUE_COMPUTE_BIT);
    if (state().faults.has("no-timestamps")) families[i].timestampValidBits = 0;
  }
}

VKAPI_ATTR void VKAPI_CALL memory_properties(VkPhysicalDevice device,
                                             VkPhysicalDeviceMemoryProperties* memory) {
  NEXT_INSTANCE(vkGetPhysicalDeviceMemoryProperties)(device, memory);
  if (!state().faults.has("heap")) return;
  for (VkMemoryHeap& heap : memory->memoryHeaps) heap.size = state().faults.value("heap");
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkDevice* device) {
  State& s = state();
  if (const VkResult result = fault("device"); result < 0) return result;
  auto* link = link_of<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  const PFN_vkGetInstanceProcAddr of_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  s.next_of_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(of_instance(s.instance, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  if (result == VK_SUCCESS) s.device = *device;
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_pool(VkDevice device, const VkCommandPoolCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkCommandPool* pool) {
  if (const VkResult result = fault("pool"); result < 0) return result;
  return NEXT_DEVICE(vkCreateCommandPool)(device, info, allocator, pool);
}

VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                        const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
  if (const VkResult result = fault("allocate"); result < 0) return result;
  const Faults& f = state().faults;
  if (f.has("largest") && info->allocationSize > f.value("largest")) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  return NEXT_DEVICE(vkAllocateMemory)(device, info, allocator, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL create_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                                const VkComputePipelineCreateInfo* infos,
                                                const VkAllocationCallbacks* allocator,
                                                VkPipeline* pipelines) {
  if (const VkResult result = fault("pipeline"); result < 0) {
    for (std::uint32_t i = 0; i < count; ++i) pipelines[i] = VK_NULL_HANDLE;
    return result;
  }
  return NEXT_DEVICE(vkCreateComputePipelines)(device, cache, count, infos, allocator, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL begin(VkCommandBuffer commands, const VkCommandBufferBeginInfo* info) {
  state().lanes = 0;
  return NEXT_DEVICE(vkBeginCommandBuffer)(commands, info);
}

VKAPI_ATTR void VKAPI_CALL dispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y,
                                    std::uint32_t z) {
  state().lanes += kGroupSize * x * y * z;
  state().dispatches.push_back(kGroupSize * x * y * z);
  NEXT_DEVICE(vkCmdDispatch)(commands, x, y, z);
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos,
                                      VkFence fence) {
  if (const VkResult result = fault("submit"); result < 0) return result;
  state().late = state().lanes * state().faults.value("lane");
  return NEXT_DEVICE(vkQueueSubmit)(queue, count, infos, fence);
}

/// A lost device's work is over, and whoever waits is told: so the real wait comes first.
VKAPI_ATTR VkResult VKAPI_CALL wait(VkDevice device, std::uint32_t count, const VkFence* fences, VkBool32 all,
                                    std::uint64_t timeout) {
  State& s = state();
  const VkResult waited = NEXT_DEVICE(vkWaitForFences)(device, count, fences, all, timeout);
  if (s.faults.has("watchdog") && s.late > s.faults.value("watchdog")) s.lost = true;
  const VkResult result = fault("wait");
  return result < 0 ? result : waited;
}

VKAPI_ATTR VkResult VKAPI_CALL wait_idle(VkDevice device) {
  const VkResult waited = NEXT_DEVICE(vkDeviceWaitIdle)(device);
  return state().lost ? VK_ERROR_DEVICE_LOST : waited;
}

/// Every second timestamp is the end of a dispatch.
VKAPI_ATTR VkResult VKAPI_CALL query_results(VkDevice device, VkQueryPool pool, std::uint32_t first,
                                             std::uint32_t count, std::size_t size, void* data,
                                             VkDeviceSize stride, VkQueryResultFlags flags) {
  if (state().lost) return VK_ERROR_DEVICE_LOST;
  const VkResult result =
      NEXT_DEVICE(vkGetQueryPoolResults)(device, pool, first, count, size, data, stride, flags);
  for (std::uint32_t i = 1; i < count; i += 2) {
    auto* ticks = reinterpret_cast<std::uint64_t*>(static_cast<char*>(data) + i * stride);
    *ticks += state().late;
    state().longest =
        std::max(state().longest,
                 *ticks - *reinterpret_cast<std::uint64_t*>(static_cast<char*>(data) + (i - 1) * stride));
  }
  return result;
}

#define HOOK(name, function) \
  { #name, reinterpret_cast < PFN_vkVoidFunction>(function) }

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL device_function(VkDevice device, const char* name);

PFN_vkVoidFunction hook(const char* name) {
  static const std::map<std::string, PFN_vkVoidFunction> hooks = {
      HOOK(vkGetDeviceProcAddr, device_function),
      HOOK(vkCreateInstance, create_instance),
      HOOK(vkEnumeratePhysicalDevices, enumerate),
      HOOK(vkGetPhysicalDeviceProperties2, properties2),
      HOOK(vkGetPhysicalDeviceQueueFamilyProperties, queue_families),
      HOOK(vkGetPhysicalDeviceMemoryProperties, memory_properties),
      HOOK(vkCreateDevice, create_device),
      HOOK(vkCreateCommandPool, create_pool),
      HOOK(vkAllocateMemory, allocate),
      HOOK(vkCreateComputePipelines, create_pipelines),
      HOOK(vkBeginCommandBuffer, begin),
      HOOK(vkCmdDispatch, dispatch),
      HOOK(vkQueueSubmit, submit),
      HOOK(vkWaitForFences, wait),
      HOOK(vkDeviceWaitIdle, wait_idle),
      HOOK(vkGetQueryPoolResults, query_results)};
  const auto found = hooks.find(name);
  return found == hooks.end() ? nullptr : found->second;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL device_function(VkDevice device, const char* name) {
  const PFN_vkVoidFunction ours = hook(name);
  return ours ? ours : state().next_of_device(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instance_function(VkInstance instance, const char* name) {
  if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(instance_function);
  const PFN_vkVoidFunction ours = hook(name);
  return ours ? ours : instance ? state().next_of_instance(instance, name) : nullptr;
}

}  // namespace
}  // namespace capcon::faults

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* layer) {
  layer->loaderLayerInterfaceVersion = 2;
  layer->pfnGetInstanceProcAddr = capcon::faults::instance_function;
  layer->pfnGetDeviceProcAddr = capcon::faults::device_function;
  layer->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
