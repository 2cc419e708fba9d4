#pragma once

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "layout.h"
#include "render/kernels.h"

namespace capcon {

/// How a dispatch's rays are dealt out where subgroups have queues of them (shaders/tracing/ray_queue.glsl):
/// on CPU devices, whose lanes run in step and read by texels. Elsewhere a lane has one ray.
class RayQueue {
 public:
  RayQueue() = default;
  /// `most_rays`: of a dispatch. `enough`: iterations after which a subgroup begins no more rays; a test may
  /// want few.
  RayQueue(const gpu::Device& device, bool texel_fetch, std::uint64_t most_rays, std::uint32_t enough);

  bool used() const { return used_; }
  /// Binds the buffer that says where queues go on.
  void bind(gpu::Kernel& kernel) const { kernel.bind(layout::kBindQueue, next_); }
  /// The constants of kernels that can have a queue.
  Constants constants() const;

  /// Deals out so many rays: fills in the push constants' `group_stride`, `group_rays`, `enough` and
  /// `resumed`. Returns the number of workgroups.
  template <class Push>
  std::uint32_t deal(Push& push, std::uint64_t rays) {
    const Deal d = deal(rays);
    push.group_stride = d.stride;
    push.group_rays = d.group_rays;
    push.enough = enough_;
    push.resumed = 0;
    return d.groups;
  }
  /// Whether the last dispatch left rays; then it is to be run again with these push constants.
  template <class Push>
  bool left(Push& push) {
    push.resumed = 1;
    return left();
  }

 private:
  struct Deal {
    std::uint32_t groups, group_rays, stride;
  };
  Deal deal(std::uint64_t rays);
  bool left();

  bool used_ = false;
  std::uint32_t enough_ = 0;
  gpu::Buffer next_;
};

}  // namespace capcon
