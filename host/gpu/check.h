#pragma once

#include <vulkan/vulkan.h>

#include "base/error.h"

namespace capcon::gpu {

/// The device or the host has no memory left: less at a time may do.
class OutOfMemory : public Failure {
 public:
  using Failure::Failure;
};

/// Throws Failure with a sentence when `result` is an error: `doing` completes "cannot ...", e.g. "create a
/// buffer". OutOfMemory where memory is what is missing.
void check(VkResult result, const char* doing);

/// "device lost" and the like.
const char* result_name(VkResult result);

}  // namespace capcon::gpu
