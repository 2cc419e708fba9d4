#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sampling/sampler.h"
#include "scene/job.h"
#include "scene/scene.h"

namespace capcon {

struct RendererState;

struct RendererOptions {
  /// "best", "lavapipe", a number as `capcon info` lists it, or part of a device's name.
  std::string device = "best";
  /// "auto" (image loads on CPU devices, storage buffers on others), "texel" or "storage".
  std::string fetch = "auto";
  bool validate = false;  ///< load the Khronos validation layer; its messages make the render fail
};

/// A scene on a Vulkan device, ready for many jobs. Building it uploads the scene; kernels are compiled on first use and
/// that time is reported apart. Failure when there is no device or it is lost.
class Renderer {
 public:
  Renderer(const Scene& scene, const RendererOptions& options);
  ~Renderer();

  /// `on_progress(fraction)` is called between batches. Same job, same device: same bits.
  RenderResult render(const AmbientOcclusionJob& job, const std::function<void(double)>& on_progress = {});

  /// The device's own points of `sampler` for pixels 0 ... pixels - 1, `sampler.count()` each: for tests against the host's.
  std::vector<FixedPoint> sample_points(const Sampler& sampler, std::uint32_t pixels, std::uint32_t dimension);

  /// What the tracer's tests and bench work on (render/ray_caster.h).
  RendererState& state() { return *state_; }

  /// Name, driver, Vulkan version, fetch variant, as JSON for reports.
  nlohmann::json device_info() const;
  /// Seconds spent in the constructor, by stage (build, upload).
  const Timings& setup() const;

 private:
  std::unique_ptr<RendererState> state_;
};

}  // namespace capcon
