#include "render/renderer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "render/ambient_occlusion.h"
#include "render/renderer_state.h"
#include "render/sample_points.h"

namespace capcon {

Renderer::Renderer(const Scene& scene, const RendererOptions& options)
    : state_(std::make_unique<RendererState>(scene, options)) {}

Renderer::~Renderer() = default;

RenderResult Renderer::render(const AmbientOcclusionJob& job, const std::function<void(double)>& on_progress) {
  RenderResult result = render_ambient_occlusion(*state_, job, on_progress);
  if (state_->instance.message_count() > 0) {
    throw Failure(fmt::format("the validation layer gave {} messages (above)", state_->instance.message_count()));
  }
  return result;
}

std::vector<FixedPoint> Renderer::sample_points(const Sampler& sampler, std::uint32_t pixels, std::uint32_t dimension) {
  return read_sample_points(*state_, sampler, pixels, dimension);
}

nlohmann::json Renderer::device_info() const {
  const gpu::DeviceDescription& d = state_->description;
  return {{"name", d.name},
          {"driver", d.driver},
          {"vulkan", d.api_version},
          {"kind", d.kind},
          {"fetch", state_->texel_fetch ? "texel" : "storage"},
          {"triangles", state_->triangle_count},
          {"quadrics", state_->quadric_count},
          {"nodes", state_->node_count},
          {"stack_entries", state_->scene_constants.at(layout::kSpecStackSize)}};
}

const Timings& Renderer::setup() const { return state_->setup; }

}  // namespace capcon
