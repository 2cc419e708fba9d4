#pragma once

#include <optional>
#include <vector>

#include "reference/direct_lighting.h"
#include "scene/job.h"
#include "shading/virtual_light.h"

namespace capcon::reference {

/// What comes by other surfaces, from virtual point lights: docs/igi.md, "The estimate".
class GlobalIllumination {
 public:
  /// Keeps references. `width`: of the image. `job.limit` is above 0 unless nothing is clamped. InputError as
  /// make_sampler.
  GlobalIllumination(const Geometry& geometry, const DirectLighting& lighting,
                     const GlobalIlluminationJob& job, const VirtualLights& lights, int width);

  /// The value of a pixel of an image of `width`, direct light included.
  DirectLighting::Estimate pixel(const View& view, int width, int x, int y) const;

 private:
  /// A VPL ready to shine.
  struct Source {
    VirtualLight light;
    Bsdf bsdf;
    Frame shading, geometric;
    double shading_ratio;  ///< r of the shading normal
  };
  /// The random numbers of one compensation ray and all that follows from it.
  struct Stream {
    std::uint32_t pixel, index;
  };

  glm::dvec3 indirect(const Vertex& x, std::uint32_t pixel, std::uint32_t set, std::uint32_t part,
                      std::uint64_t& rays) const;
  glm::dvec3 gather(const Vertex& x, std::uint32_t set, std::uint64_t& rays) const;
  Source source(const VirtualLight& light) const;
  glm::dvec3 from(const Vertex& x, const Source& y, std::uint64_t& rays) const;
  /// The same of a two-sided VPL that x is behind.
  glm::dvec3 from_behind(const Vertex& x, const Source& y, std::uint64_t& rays) const;
  /// What clamping took from x, by one ray; `surface`: how many lie between the pixel's and the ray's.
  glm::dvec3 compensate(const Vertex& x, const glm::dvec2& point, double choice, std::uint32_t set,
                        const Stream& stream, std::uint32_t surface, std::uint64_t& rays) const;
  /// What a surface that a compensation ray met reflects.
  glm::dvec3 reflected(const Vertex& y, std::uint32_t set, const Stream& stream, std::uint32_t surface,
                       std::uint64_t& rays) const;
  FixedPoint number(const Stream& stream, std::uint32_t surface, std::uint32_t pair) const;

  const Geometry& geometry_;
  const DirectLighting& lighting_;
  GlobalIlluminationJob job_;
  DirectPoints points_;
  std::vector<Source> sources_;
  std::vector<Source> behind_;        ///< the same as if their paths had come from behind; for two-sided ones
  std::vector<std::uint32_t> first_;  ///< VirtualLights::first
  double limit_;
  std::optional<DirectPoints> rays_;  ///< points of compensation rays from what pixels see
};

}  // namespace capcon::reference
