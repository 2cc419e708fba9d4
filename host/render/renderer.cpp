#include "render/renderer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "gpu/check.h"
#include "render/ambient_occlusion.h"
#include "render/direct_lighting.h"
#include "render/global_illumination.h"
#include "render/light_paths.h"
#include "render/renderer_state.h"
#include "render/sample_points.h"

namespace capcon {
namespace {

RenderResult integrate(RendererState& state, const Job& job, int first_row, int rows,
                       const std::function<void(double)>& on_progress) {
  if (const auto* direct = std::get_if<DirectLightingJob>(&job))
    return render_direct_lighting(state, *direct, first_row, rows, on_progress);
  if (const auto* occlusion = std::get_if<AmbientOcclusionJob>(&job))
    return render_ambient_occlusion(state, *occlusion, first_row, rows, on_progress);
  if (const auto* igi = std::get_if<GlobalIlluminationJob>(&job))
    return render_global_illumination(state, *igi, first_row, rows, on_progress);
  throw InputError("path tracing is for the reference alone: add --device reference");
}

}  // namespace

Renderer::Renderer(const Scene& scene, const RendererOptions& options)
    : Renderer(scene, options, open_device(options), nullptr) {}

Renderer::Renderer(const Scene& scene, const RendererOptions& options, PendingDevice device, const Job* first)
    : state_(std::make_unique<RendererState>(scene, options, device.get(), first)) {}

Renderer::~Renderer() = default;

RenderResult Renderer::render(const Job& job, const std::function<void(double)>& on_progress) {
  return render_rows(job, 0, state_->film.height, on_progress);
}

RenderResult Renderer::render_rows(const Job& job, int first_row, int rows,
                                   const std::function<void(double)>& on_progress) {
  RenderResult result;
  for (bool done = false; !done;) {
    try {
      result = integrate(*state_, job, first_row, rows, on_progress);
      done = true;
    } catch (const gpu::OutOfMemory&) {
      // What a job needs beside the scene can be less at a time: the same bits, a little later.
      if (!state_->shrink()) throw;
    }
  }
  const int messages = state_->context->instance.message_count();
  if (messages > 0) throw Failure(fmt::format("the validation layer gave {} messages (above)", messages));
  return result;
}

VirtualLights Renderer::virtual_lights(const GlobalIlluminationJob& job) {
  check_job(job);
  if (!state_->features.shading) throw Failure("this renderer was made for ambient occlusion alone");
  Timings timings;
  return unpack(trace_light_paths(*state_, job, timings), state_->placement, state_->default_material);
}

std::vector<FixedPoint> Renderer::sample_points(const Sampler& sampler, std::uint32_t pixels,
                                                std::uint32_t dimension, SampleDomain domain) {
  return read_sample_points(*state_, sampler, pixels, dimension, domain);
}

nlohmann::json Renderer::device_info() const {
  const gpu::DeviceDescription& d = state_->description;
  return {{"name", d.name},
          {"driver", d.driver},
          {"vulkan", d.api_version},
          {"kind", d.kind},
          {"fetch", state_->kernels.texel_fetch() ? "texel" : "storage"},
          {"triangles", state_->triangle_count},
          {"quadrics", state_->quadric_count},
          {"instances", state_->instance_count},
          {"buffer_bytes", state_->buffer_bytes()},
          {"nodes", state_->node_count},
          {"stack_entries", state_->scene_constants.at(layout::kSpecStackSize)}};
}

const std::vector<std::string>& Renderer::warnings() const {
  return state_->warnings;
}

const Timings& Renderer::setup() const {
  return state_->setup;
}

}  // namespace capcon
