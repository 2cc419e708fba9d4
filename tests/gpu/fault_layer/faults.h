#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <map>
#include <string>

namespace capcon::faults {

/// What $CAPCON_TEST_FAULTS asks for: words with commas between them.
///   submit:5=device-lost     the 5th vkQueueSubmit fails; "5+": all from there on. Also wait
///   (vkWaitForFences), allocate
///                            (vkAllocateMemory), pipeline, pool (vkCreateCommandPool), device, instance;
///                            results: device-lost, no-device-memory, no-host-memory, failed
///   largest=4194304          no allocation above that
///   storage=N, texels=N, heap=N, bindings=N   limits of the device
///   no-device, no-compute, no-timestamps, no-votes, old    what the device has not
///   lane=20000, watchdog=2000000000   nanoseconds that each lane takes, and after which a dispatch loses the
///   device;
///                            nothing waits for them: they are added to the timestamps
///   log=PATH                 a line for each dispatch with its lanes; at the end how often each call came,
///   "submit N" and so on,
///                            and "longest T", the time of the longest dispatch in timestamps (nanoseconds on
///                            lavapipe)
struct Faults {
  struct Call {
    std::uint64_t number = 0;
    bool onwards = false;
    VkResult result = VK_SUCCESS;
  };
  std::map<std::string, Call> calls;
  std::map<std::string, std::uint64_t> values;
  std::map<std::string, std::uint64_t> counts;  ///< calls so far
  std::string log;

  bool has(const std::string& word) const { return values.count(word) > 0; }
  std::uint64_t value(const std::string& word) const {
    const auto found = values.find(word);
    return found == values.end() ? 0 : found->second;
  }
  /// Counts a call; the error it must give, or VK_SUCCESS.
  VkResult called(const std::string& what);
};

/// Of the environment; ends the program with a message where a word makes no sense: a test that asks for it
/// is wrong.
Faults read_faults();

}  // namespace capcon::faults
