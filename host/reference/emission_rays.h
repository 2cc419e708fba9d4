#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/geometry.h"
#include "reference/light_sampling.h"
#include "shading/scene_bounds.h"

namespace capcon::reference {

/// How light leaves a light.
struct EmissionRay {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< unit
  glm::dvec3 flux;       ///< W, of one path alone
  Ignored ignored;       ///< what the ray must not be tested against
};

/// Where light paths start: the table of docs/igi.md, "Light paths".
class EmissionRays {
 public:
  /// Keeps references.
  EmissionRays(const Scene& scene, const Geometry& geometry, const LightSampling& lights);

  /// The domains of the points for start(): those of the light if there is only one.
  SampleDomain origin_domain() const;
  SampleDomain direction_domain() const;
  /// By the bits of the point that chooses light and origin, the point in [0, 1)^2 for the direction, and the
  /// number in [0, 1) that chooses a side. None where nothing is emitted.
  std::optional<EmissionRay> start(FixedPoint origin, const glm::dvec2& direction, double side) const;

 private:
  EmissionRay from_area(int light, const glm::dvec2& u, const glm::dvec2& v, double side) const;
  EmissionRay from_afar(const Light& light, const glm::dvec2& u, const glm::dvec2& v) const;

  const Scene& scene_;
  const Geometry& geometry_;
  const LightSampling& lights_;
  BoundingSphere bounds_;
  std::vector<std::uint32_t> thresholds_;
};

}  // namespace capcon::reference
