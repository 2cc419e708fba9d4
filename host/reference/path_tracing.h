#pragma once

#include "reference/direct_lighting.h"
#include "scene/job.h"

namespace capcon::reference {

/// Unidirectional path tracing (Kajiya, "The Rendering Equation", 1986) with points on all lights at every
/// surface, combined with those that the paths meet by the balance heuristic. It takes of the other
/// estimators only what surfaces, BSDFs and lights are.
class PathTracing {
 public:
  /// Keeps references.
  PathTracing(const Geometry& geometry, const Vertices& vertices, const LightSampling& lights)
      : geometry_(geometry), vertices_(vertices), lights_(lights) {}

  /// The mean of a pixel's paths. `rays`: all that were traced but those from the eye.
  DirectLighting::Estimate pixel(const PathTracingJob& job, const View& view, int width, int x, int y) const;

 private:
  class Numbers;
  glm::dvec3 path(const Ray& from_eye, const Numbers& numbers, bool only_indirect, std::uint64_t& rays) const;
  glm::dvec3 next_event(const Vertex& vertex, const Numbers& numbers, std::uint32_t surface,
                        std::uint64_t& rays) const;
  /// What a ray that left `vertex` with density `pdf` (of the eye: nullptr) brings from lights.
  glm::dvec3 met(const Ray& ray, const std::optional<Seen>& seen, const Vertex* vertex, double pdf) const;

  const Geometry& geometry_;
  const Vertices& vertices_;
  const LightSampling& lights_;
};

}  // namespace capcon::reference
