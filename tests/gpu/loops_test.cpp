#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/hash.h"
#include "gpu/commands.h"
#include "spirv/loops_storage.h"
#include "spirv/loops_texel.h"

namespace capcon {
namespace {

using gpu::Access;
using Words = std::array<std::uint32_t, 4>;
constexpr std::uint32_t kThreads = 4096, kLinks = 997, kPatterns = 6;

/// A value, the next link, and in every ninth link or so 1.
std::vector<Words> make_chain() {
  std::vector<Words> chain(kLinks);
  for (std::uint32_t i = 0; i < kLinks; ++i) {
    const auto random = [&](int k) { return static_cast<std::uint32_t>(uniform64(5, i, k) * 4294967295.0); };
    chain[i] = {random(0), random(1) % kLinks, random(2) % 9 == 0, 0};
  }
  return chain;
}

/// What tests/shaders/loops.comp must find, written as any CPU would.
Words expected(const std::vector<Words>& chain, std::uint32_t pattern, std::uint32_t thread) {
  const std::uint32_t count = 1 + (thread * 2654435761u >> 24) % 61;
  std::uint32_t link = thread % kLinks, value = 0, sum = 0, steps = 0;
  if (pattern == 5) {
    for (; steps < 40000; ++steps) sum += link ^ steps;
    for (; steps < 65535; ++steps) value = value * 3 + steps;
    return {value, pattern, steps, sum};
  }
  for (; steps < count; ++steps) {
    const auto [x, next, end, unused] = chain[link];
    switch (pattern) {
      case 0:
        value = x & 1 ? x : value, sum += x;
        break;
      case 2:
        value |= x & ~next, sum = std::max(sum, x);
        break;
      case 4:
        for (std::uint32_t pending = end ? x | 1 : 0; pending != 0; pending >>= 1) {
          sum += pending & 1;
          if (pending & 1) value ^= (steps + 1) * 2654435761u;
        }
        break;
      default:
        value = x, sum += x;
    }
    link = next;
  }
  return {value, pattern, steps, sum};
}

// Both bugs are silent: a kernel written the wrong way gives wrong values and no message.
TEST(Loops, ReadAfterDivergentLoopsAsTheCpuDoes) {
  const gpu::Instance instance(true);
  const gpu::Device device(instance, instance.choose("lavapipe"));
  const auto chain = make_chain();
  const gpu::Buffer links = gpu::make_buffer<Words>(device, chain);
  const gpu::Buffer found(device, sizeof(Words) * kThreads, gpu::Memory::host);
  for (const bool texel : {true, false}) {
    const std::span<const std::uint32_t> spirv = texel
                                                     ? std::span<const std::uint32_t>(k_loops_texel_spirv)
                                                     : std::span<const std::uint32_t>(k_loops_storage_spirv);
    for (std::uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
      gpu::Kernel kernel(device, spirv, {{0, texel ? Access::texels : Access::storage}, {1, Access::storage}},
                         {{0, pattern}}, 0);
      kernel.bind(0, links);
      kernel.bind(1, found);
      gpu::Commands commands(device);
      commands.dispatch(kernel, nullptr, kThreads / 64, "loops");
      commands.submit_and_wait();
      std::vector<Words> answers(kThreads);
      found.download(answers.data(), sizeof(Words) * kThreads);
      std::uint32_t wrong = 0;
      for (std::uint32_t t = 0; t < kThreads; ++t) wrong += answers[t] != expected(chain, pattern, t);
      EXPECT_EQ(wrong, 0u) << "pattern " << pattern << (texel ? ", texels" : ", storage");
    }
  }
  EXPECT_EQ(instance.message_count(), 0) << "the validation layer complained";
}

}  // namespace
}  // namespace capcon
