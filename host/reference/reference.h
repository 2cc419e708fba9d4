#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scene/job.h"
#include "scene/scene.h"
#include "shading/virtual_light.h"

namespace capcon {

/// The oracle: the same jobs in double precision on the CPU, with its own traversal, warps and offsets. It
/// shares with the device side only the scene and the bits of the sample points.
class Reference {
 public:
  /// Keeps a reference. What lights and materials need is made when the first job asks for it.
  explicit Reference(const Scene& scene);
  explicit Reference(const Scene&& scene) = delete;
  ~Reference();
  RenderResult render(const AmbientOcclusionJob& job,
                      const std::function<void(double)>& on_progress = {}) const;
  /// docs/direct.md. InputError as read_lights, read_materials and make_sampler.
  RenderResult render(const DirectLightingJob& job,
                      const std::function<void(double)>& on_progress = {}) const;
  /// docs/igi.md, with the VPLs of its own light paths. InputError where none of them hits anything or no
  /// light emits, and for jobs that make no sense.
  RenderResult render(const GlobalIlluminationJob& job,
                      const std::function<void(double)>& on_progress = {}) const;
  /// With given VPLs, such as a device's: their number of sets is the job's.
  RenderResult render(const GlobalIlluminationJob& job, const VirtualLights& lights,
                      const std::function<void(double)>& on_progress = {}) const;
  /// Shares nothing with instant global illumination but BSDFs, lights and the tracer.
  RenderResult render(const PathTracingJob& job, const std::function<void(double)>& on_progress = {}) const;
  RenderResult render(const Job& job, const std::function<void(double)>& on_progress = {}) const;
  VirtualLights trace_virtual_lights(const GlobalIlluminationJob& job) const;
  /// What of the scene's materials and lights is only approximated; empty before the first direct job.
  std::vector<std::string> warnings() const;
  const Timings& setup() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace capcon
