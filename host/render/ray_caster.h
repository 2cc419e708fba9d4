#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "render/renderer.h"

namespace capcon {

/// A ray in the device's space (render/placement.h), as 32 bytes.
struct DeviceRay {
  glm::vec3 origin;
  float t_max = 3e38f;
  glm::vec3 direction;               ///< unit length
  std::uint32_t skip = 0xffffffffu;  ///< a primitive that does not count, or none
};

struct DeviceHit {
  float t;                  ///< distance, in the device's space; meaningless where nothing was met
  std::uint32_t primitive;  ///< id as in Geometry, 0xffffffff: nothing was met
};

/// Given rays against a renderer's scene, for tests and the tracer's bench. Rays are uploaded once, cast as
/// often as wanted.
class RayCaster {
 public:
  RayCaster(RendererState& state, std::span<const DeviceRay> rays);
  ~RayCaster();

  /// Casts all rays; with `any`, the first primitive that is found ends a ray. Returns device seconds.
  double cast(bool any);
  std::vector<DeviceHit> hits() const;

 private:
  struct Buffers;
  RendererState& state_;
  std::size_t count_;
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace capcon
