#pragma once

#include <vulkan/vulkan.h>

namespace capcon::gpu {

/// Throws Failure with a sentence when `result` is an error: `doing` completes "cannot ...", e.g. "create a buffer".
void check(VkResult result, const char* doing);

/// "device lost" and the like.
const char* result_name(VkResult result);

}  // namespace capcon::gpu
