#pragma once

#include <cstdint>
#include <memory>

#include "reference/geometry.h"
#include "reference/light_sampling.h"
#include "reference/vertex.h"
#include "reference/view.h"
#include "sampling/sampler.h"
#include "scene/job.h"

namespace capcon::reference {

/// The points of one job.
class DirectPoints {
 public:
  /// `width`: of the image. InputError as make_sampler.
  DirectPoints(const DirectLightingJob& job, int width);
  /// Where in the film's pixel (x, y) image sample p lies.
  glm::dvec2 film(std::uint32_t pixel, int x, int y, std::uint32_t p) const;
  /// Point i of image sample p, of a dimension pair other than the film's, in [0, 1)^2.
  glm::dvec2 operator()(std::uint32_t pixel, std::uint32_t p, std::uint32_t i, std::uint32_t pair,
                        SampleDomain domain) const;
  /// The number that chooses the component of the BSDF.
  double choice(std::uint32_t pixel, std::uint32_t p, std::uint32_t i) const;

 private:
  DirectLightingJob job_;
  std::unique_ptr<Sampler> integrand_;
  std::unique_ptr<Sampler> image_;  ///< none where all image samples are at the centre
};

/// The estimator of docs/direct.md.
class DirectLighting {
 public:
  /// Keeps references.
  DirectLighting(const Scene& scene, const Geometry& geometry)
      : geometry_(geometry), vertices_(scene, geometry), lights_(scene, geometry.primitives) {}

  /// What of materials and lights is only approximated.
  std::vector<std::string> warnings() const;

  struct Estimate {
    glm::dvec3 radiance{0};
    std::uint64_t rays = 0;  ///< shadow rays and BSDF rays
  };
  /// The value of a pixel.
  Estimate pixel(const DirectLightingJob& job, const DirectPoints& points, const View& view, int width, int x,
                 int y) const;

  /// The two lines of the estimate, for one integrator sample; `rays` counts those traced.
  glm::dvec3 light_sample(const Vertex& vertex, int light, const glm::dvec2& point, Strategy strategy,
                          std::uint64_t& rays) const;
  glm::dvec3 bsdf_sample(const Vertex& vertex, const glm::dvec2& point, double choice, Strategy strategy,
                         std::uint64_t& rays) const;

  const Vertices& vertices() const { return vertices_; }
  const LightSampling& lights() const { return lights_; }

 private:
  glm::dvec3 emitted(const Seen& seen, const Ray& ray) const;

  const Geometry& geometry_;
  Vertices vertices_;
  LightSampling lights_;
};

}  // namespace capcon::reference
