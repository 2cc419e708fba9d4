#include "gpu/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "gpu/check.h"

namespace capcon::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  auto* count = static_cast<std::atomic<int>*>(user);
  count->fetch_add(1);
  fmt::print(stderr, "validation: {}\n", data->pMessage);
  return VK_FALSE;
}

bool has_layer(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(),
                     [&](const auto& l) { return std::strcmp(l.layerName, name) == 0; });
}

const char* kind_name(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "cpu";
    default:
      return "other";
  }
}

int rank_of(const DeviceDescription& d) {
  const char* order[] = {"discrete", "integrated", "virtual", "cpu"};
  for (int r = 0; r < 4; ++r) {
    if (d.kind == order[r]) return r;
  }
  return 4;
}

/// What a device lacks, as in "it has no ...".
std::string missing(VkPhysicalDevice device, const VkPhysicalDeviceProperties& p,
                    const VkPhysicalDeviceSubgroupProperties& subgroup) {
  if (p.apiVersion < VK_API_VERSION_1_2) return "Vulkan 1.2";
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  const auto any = [&](std::uint32_t timestamp_bits) {
    return std::any_of(families.begin(), families.end(), [&](const auto& f) {
      return (f.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0 && f.timestampValidBits >= timestamp_bits;
    });
  };
  if (!any(0)) return "compute queue";
  if (!any(1)) return "timestamps on its compute queues";
  constexpr VkSubgroupFeatureFlags kVotes = VK_SUBGROUP_FEATURE_VOTE_BIT | VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
  if ((subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) == 0 ||
      (subgroup.supportedOperations & kVotes) != kVotes)
    return "subgroup votes and shuffles in compute shaders";
  return {};
}

DeviceDescription describe(VkPhysicalDevice device) {
  VkPhysicalDeviceSubgroupProperties subgroup{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES, nullptr, 0, 0, 0, 0};
  VkPhysicalDeviceDriverProperties driver{};
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  driver.pNext = &subgroup;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(device, &properties);
  const VkPhysicalDeviceProperties& p = properties.properties;
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(device, &memory);

  DeviceDescription d;
  d.handle = device;
  d.name = p.deviceName;
  d.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  d.api_version = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(p.apiVersion),
                              VK_API_VERSION_MINOR(p.apiVersion), VK_API_VERSION_PATCH(p.apiVersion));
  d.kind = kind_name(p.deviceType);
  d.subgroup_size = subgroup.subgroupSize;
  d.max_storage_bytes = p.limits.maxStorageBufferRange;
  d.max_texels = p.limits.maxTexelBufferElements;
  d.max_bindings =
      std::min(p.limits.maxPerStageDescriptorStorageBuffers, p.limits.maxPerStageDescriptorStorageImages);
  for (std::uint32_t h = 0; h < memory.memoryHeapCount; ++h) {
    if (memory.memoryHeaps[h].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
      d.memory_bytes = std::max<std::uint64_t>(d.memory_bytes, memory.memoryHeaps[h].size);
    }
  }
  d.lacks = missing(device, p, subgroup);
  return d;
}

}  // namespace

Instance::Instance(bool validate) {
  // lavapipe says "XDG_RUNTIME_DIR is invalid" on stderr when it is unset, though headless work needs none.
  ::setenv("XDG_RUNTIME_DIR", "/tmp", 0);
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "capcon";
  application.apiVersion = VK_API_VERSION_1_2;
  std::vector<const char*> layers, extensions;
  if (validate) {
    if (!has_layer(kValidationLayer)) {
      throw Failure(
          "the Vulkan validation layer is not installed; install the package vulkan-validationlayers");
    }
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
  }
  const VkValidationFeatureEnableEXT synchronisation =
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &synchronisation;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pNext = validate ? &features : nullptr;
  info.pApplicationInfo = &application;
  info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
  info.ppEnabledLayerNames = layers.data();
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  const VkResult result = vkCreateInstance(&info, nullptr, &handle_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
    throw Failure(
        "there is no Vulkan driver; install mesa-vulkan-drivers for a software one, or use --device "
        "reference");
  }
  check(result, "create an instance");
  if (!validate) return;
  VkDebugUtilsMessengerCreateInfoEXT messenger{};
  messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messenger.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messenger.pfnUserCallback = on_message;
  messenger.pUserData = message_count_.get();
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(handle_, "vkCreateDebugUtilsMessengerEXT"));
  check(create(handle_, &messenger, nullptr, &messenger_), "listen to the validation layer");
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(handle_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(handle_, messenger_, nullptr);
  }
  if (handle_ != VK_NULL_HANDLE) vkDestroyInstance(handle_, nullptr);
}

std::vector<DeviceDescription> Instance::devices() const {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(handle_, &count, nullptr), "list the devices");
  std::vector<VkPhysicalDevice> handles(count);
  check(vkEnumeratePhysicalDevices(handle_, &count, handles.data()), "list the devices");
  std::vector<DeviceDescription> all;
  for (const VkPhysicalDevice handle : handles) all.push_back(describe(handle));
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::pair(rank_of(a), b.memory_bytes) < std::pair(rank_of(b), a.memory_bytes);
  });
  return all;
}

DeviceDescription Instance::choose(const std::string& selector) const {
  const auto all = devices();
  if (all.empty()) {
    throw Failure(
        "there is no Vulkan device; install mesa-vulkan-drivers for a software one, or use --device "
        "reference");
  }
  const auto lower = [](std::string s) {
    std::transform(s.begin(), s.end(), s.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
  };
  const std::string wanted = selector == "lavapipe" ? "llvmpipe" : lower(selector);
  const bool number =
      !selector.empty() && selector.size() < 6 && std::all_of(selector.begin(), selector.end(), ::isdigit);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool fits = selector == "best" ? all[i].usable()
                      : number           ? std::to_string(i) == selector
                                         : lower(all[i].name).find(wanted) != std::string::npos;
    if (!fits) continue;
    if (!all[i].usable())
      throw Failure(fmt::format("device {} ({}) has no {}; choose another --device, or reference", i,
                                all[i].name, all[i].lacks));
    return all[i];
  }
  if (selector == "best") {
    throw Failure(fmt::format(
        "no Vulkan device can be used: {} has no {}; install mesa-vulkan-drivers for a software one, "
        "or use --device reference",
        all.front().name, all.front().lacks));
  }
  std::string names;
  for (std::size_t i = 0; i < all.size(); ++i)
    names += fmt::format("{}{}: {}", i ? ", " : "", i, all[i].name);
  throw InputError(
      fmt::format("no Vulkan device fits \"{}\"; there is {}; or use reference", selector, names));
}

}  // namespace capcon::gpu
