#include "gpu/check.h"

#include <fmt/format.h>

namespace capcon::gpu {

const char* result_name(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "initialisation failed";
    case VK_ERROR_DEVICE_LOST:
      return "device lost";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "memory map failed";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "incompatible driver";
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "too many objects";
    default:
      return "unknown error";
  }
}

void check(VkResult result, const char* doing) {
  if (result >= 0) return;
  const auto sentence = [&](const char* advice) {
    return fmt::format("Vulkan cannot {}: {} (VkResult {}); {}", doing, result_name(result),
                       static_cast<int>(result), advice);
  };
  if (result == VK_ERROR_DEVICE_LOST)
    throw Failure(
        sentence("its driver failed or was reset: try again, and if it stays so another --device, such as "
                 "lavapipe or reference"));
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    throw OutOfMemory(sentence("try a smaller scene or image, or another --device"));
  throw Failure(sentence("try a newer driver or another --device, such as lavapipe or reference"));
}

}  // namespace capcon::gpu
