#include "render/ray_caster.h"

#include <algorithm>

#include "render/dispatch.h"
#include "render/renderer_state.h"

namespace capcon {

struct RayCaster::Buffers {
  gpu::Buffer rays, hits;
};

RayCaster::RayCaster(RendererState& state, std::span<const DeviceRay> rays)
    : state_(state), count_(rays.size()), buffers_(std::make_unique<Buffers>()) {
  static_assert(sizeof(DeviceRay) == 32 && sizeof(DeviceHit) == 8);
  buffers_->rays = gpu::make_buffer(state.device, rays);
  buffers_->hits = gpu::Buffer(state.device, 8 * rays.size(), gpu::Memory::host);
}

RayCaster::~RayCaster() = default;

double RayCaster::cast(bool any) {
  auto constants = state_.scene_constants;
  constants[layout::kSpecAnyHit] = any ? 1 : 0;
  constants.merge(any ? state_.ray_queue.constants() : Constants());
  const auto bind = [&](gpu::Kernel& kernel) {
    state_.bind_all(kernel);
    kernel.bind(layout::kBindRays, buffers_->rays);
    kernel.bind(layout::kBindHits, buffers_->hits);
  };
  gpu::Kernel& kernel = state_.kernels.get("rays", constants, bind);
  bind(kernel);  // an earlier caster's buffers may be bound
  double seconds = 0;
  layout::RayConstants push{};
  push.tree = state_.tree;
  Batches batches = state_.batches();
  for (std::size_t first = 0; first < count_; first += push.count) {
    push.first = static_cast<std::uint32_t>(first);
    push.count = static_cast<std::uint32_t>(std::min<std::size_t>(batches.lanes(kernel), count_ - first));
    const std::uint32_t groups = any ? state_.ray_queue.deal(push, push.count) : groups_for(push.count);
    if (!any) push.group_stride = 1;  // neighbours one after the other, as primary rays are: they share nodes
    do {
      gpu::Commands commands(state_.device);
      commands.dispatch(kernel, &push, groups, "rays");
      commands.submit_and_wait();
      batches.took(kernel, push.resumed == 0 ? push.count : 0, commands.times().front().seconds);
      seconds += commands.times().front().seconds;
    } while (any && state_.ray_queue.left(push));
  }
  return seconds;
}

std::vector<DeviceHit> RayCaster::hits() const {
  std::vector<DeviceHit> hits(count_);
  buffers_->hits.download(hits.data(), 8 * count_);
  return hits;
}

}  // namespace capcon
