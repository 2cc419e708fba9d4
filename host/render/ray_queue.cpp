#include "render/ray_queue.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/dispatch.h"

namespace capcon {
namespace {

// Rays of a lane, on average: more gain little (docs/tracer.md), fewer where threads would have few groups to
// share.
constexpr std::uint64_t kMostRaysALane = 64, kGroupsAThread = 32;
constexpr std::uint64_t kLanes = layout::kQueueGroupSize, kFewestLanes = 4;  // of a subgroup

std::uint64_t groups_to_share() {
  return kGroupsAThread * thread_count();
}

}  // namespace

RayQueue::RayQueue(const gpu::Device& device, bool texel_fetch, std::uint64_t most_rays, std::uint32_t enough)
    : used_(device.is_cpu() && texel_fetch), enough_(enough) {
  const std::uint64_t groups =
      used_ ? std::max(2 * groups_to_share(), most_rays / (kLanes * kMostRaysALane)) + 1 : 0;
  next_ = gpu::Buffer(device, 4 * (1 + groups * (kLanes / kFewestLanes)), gpu::Memory::host);
  next_.clear();
}

Constants RayQueue::constants() const {
  if (!used_) return {};
  return {{layout::kSpecQueue, 1}, {layout::kSpecGroupSize, layout::kQueueGroupSize}};
}

RayQueue::Deal RayQueue::deal(std::uint64_t rays) {
  Deal d{};
  if (used_) {
    const std::uint32_t none = 0;  // a job that was cancelled may have left some
    next_.upload(&none, 4);
    const std::uint64_t each =
        std::clamp<std::uint64_t>(rays / (groups_to_share() * kLanes), 1, kMostRaysALane);
    d.group_rays = static_cast<std::uint32_t>(each * kLanes);
    d.groups = static_cast<std::uint32_t>((rays + d.group_rays - 1) / d.group_rays);
  } else {
    d.groups = groups_for(rays);
  }
  d.stride = spreading_stride(d.groups);
  return d;
}

bool RayQueue::left() {
  if (!used_) return false;
  std::uint32_t subgroups = 0;
  next_.download(&subgroups, 4);
  if (subgroups == 0) return false;
  const std::uint32_t none = 0;
  next_.upload(&none, 4);
  return true;
}

}  // namespace capcon
