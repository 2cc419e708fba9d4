#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/device_context.h"
#include "sampling/sampler.h"
#include "scene/job.h"
#include "scene/scene.h"
#include "shading/virtual_light.h"

namespace capcon {

struct RendererState;

/// A scene on a Vulkan device, ready for many jobs. Building it uploads the scene; kernels are compiled on
/// first use and that time is reported apart. Failure when there is no device or it is lost.
class Renderer {
 public:
  Renderer(const Scene& scene, const RendererOptions& options);
  /// The same on a device that is being opened already. The kernels of `first`, the job to come, are compiled
  /// while the tree is built.
  Renderer(const Scene& scene, const RendererOptions& options, PendingDevice device, const Job* first);
  ~Renderer();

  /// `on_progress(fraction)` is called after every dispatch, so several times a second; what it throws ends
  /// the job, and the renderer is ready for the next. Same job, same device: same bits.
  RenderResult render(const Job& job, const std::function<void(double)>& on_progress = {});

  /// Rows first_row ... first_row + rows - 1 alone, the same bits as in the whole image: for images that are
  /// written as they come. Any number of rows; the device holds at most 2^21 pixels at a time.
  RenderResult render_rows(const Job& job, int first_row, int rows,
                           const std::function<void(double)>& on_progress = {});

  /// The VPLs that render() makes for this job, without rendering. Primitives are the device's ids.
  VirtualLights virtual_lights(const GlobalIlluminationJob& job);

  /// The device's own points of `sampler` for pixels 0 ... pixels - 1, `sampler.count()` each: for tests
  /// against the host's.
  std::vector<FixedPoint> sample_points(const Sampler& sampler, std::uint32_t pixels, std::uint32_t dimension,
                                        SampleDomain domain = SampleDomain::square);

  /// What the tracer's tests and bench work on (render/ray_caster.h).
  RendererState& state() { return *state_; }

  /// Name, driver, Vulkan version, fetch variant, as JSON for reports.
  nlohmann::json device_info() const;
  /// What of the scene's materials and lights is only approximated, a sentence each; empty for ambient
  /// occlusion.
  const std::vector<std::string>& warnings() const;

  /// Seconds spent in the constructor, by stage (device, build, upload); compiling beside them is told by the
  /// first render.
  const Timings& setup() const;

 private:
  std::unique_ptr<RendererState> state_;
};

}  // namespace capcon
