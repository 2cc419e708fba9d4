#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "reference/reference.h"
#include "reference/scenes.h"
#include "scene/scene_text.h"

namespace capcon::test {

/// The square [-50, 50]^2 in the plane z = 0, facing +z.
inline const std::string kFloor =
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 0 50 -50 0 50 50 0 -50 50 0] \"integer indices\" [0 1 2 0 "
    "2 3]\n";

inline std::string within(const std::string& text) {
  return "AttributeBegin " + text + " AttributeEnd\n";
}
/// An area light of radiance 1: `text` transforms and makes the shape.
inline std::string lamp(const std::string& text, const std::string& parameters = "") {
  return within("AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] " + parameters + text);
}
inline std::string matte(double albedo) {
  const std::string a = std::to_string(albedo);
  return "Material \"diffuse\" \"rgb reflectance\" [" + a + " " + a + " " + a + "]\n";
}

/// A world whose pixels all see the same point: the origin, obliquely from above.
inline Scene look_at_origin(const std::string& text, int side = 1, const glm::dvec3& eye = {0.7, -0.4, 0.8}) {
  Scene scene = parse_world(text, {true, true, true});
  scene.film = {side, side, ""};
  scene.camera = camera_at(eye, -eye, 1e-9);
  return scene;
}

inline DirectLightingJob direct_job(std::uint32_t samples, Strategy strategy = Strategy::power) {
  DirectLightingJob job;
  job.sampler = "sobol-owen";
  job.integrator_samples = samples;
  job.strategy = strategy;
  job.seed = 5;
  return job;
}

inline glm::dvec3 pixel(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// The value of a scene of one pixel.
inline glm::dvec3 radiance(const Scene& scene, const DirectLightingJob& job) {
  return pixel(Reference(scene).render(job).image, 0, 0);
}

/// Mean of the red channel over the pixels, and its standard error.
struct Estimate {
  double mean = 0, error = 0;
};
inline Estimate estimate(const Image& image) {
  Estimate result;
  const double count = double(image.width) * image.height;
  double squares = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) result.mean += image.at(x, y, 0) / count;
  }
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) squares += std::pow(image.at(x, y, 0) - result.mean, 2);
  }
  result.error = std::sqrt(squares / (count - 1) / count);
  return result;
}

}  // namespace capcon::test
