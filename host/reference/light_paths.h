#pragma once

#include <memory>
#include <vector>

#include "reference/direct_lighting.h"
#include "reference/emission_rays.h"
#include "scene/job.h"
#include "shading/virtual_light.h"

namespace capcon::reference {

/// The light paths of a job: docs/igi.md, "Light paths".
class LightPaths {
 public:
  /// Keeps references. InputError as make_sampler, and where no light emits.
  LightPaths(const Scene& scene, const Geometry& geometry, const DirectLighting& lighting,
             const GlobalIlluminationJob& job);

  /// The hits of path `index` of a set, in order.
  std::vector<VirtualLight> path(std::uint32_t set, std::uint32_t index) const;
  /// Of all paths. InputError where none hits anything.
  VirtualLights all() const;

 private:
  FixedPoint point(std::uint32_t set, std::uint32_t index, std::uint32_t bounce, std::uint32_t pair,
                   SampleDomain domain) const;
  double choice(std::uint32_t set, std::uint32_t index, std::uint32_t bounce) const;

  const Geometry& geometry_;
  const Vertices& vertices_;
  EmissionRays emission_;
  std::string scene_name_;
  std::uint32_t paths_, sets_;
  bool partition_;
  std::uint32_t seed_;
  std::unique_ptr<Sampler> sampler_;
};

}  // namespace capcon::reference
