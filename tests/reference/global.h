#pragma once

#include <vector>

#include "reference/lighting.h"

namespace capcon::test {

/// Three walls that meet at (-1, 1, 0), two units wide: a floor and two sides, as one mesh.
inline const std::string kCorner =
    "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0 -1 -1 2 -1 1 2 1 1 2] "
    "\"point2 uv\" [0 0 1 0 1 1 0 1 .5 1 1 .5 .5 0] "
    "\"integer indices\" [0 1 2 0 2 3 0 3 5 0 5 4 3 2 6 3 6 5]\n";

/// The inside of the cube [-1, 1]^3, of one mesh.
inline const std::string kBox =
    "Shape \"trianglemesh\" \"point3 P\" [-1 -1 -1 1 -1 -1 1 1 -1 -1 1 -1 -1 -1 1 1 -1 1 1 1 1 -1 1 1] "
    "\"integer indices\" [0 1 2 0 2 3 4 6 5 4 7 6 0 5 1 0 4 5 3 2 6 3 6 7 0 3 7 0 7 4 1 6 2 1 5 6]\n";

/// A disk above the corner's floor that shines down.
inline const std::string kCornerLamp =
    lamp("ReverseOrientation Translate .2 0 1.5 Shape \"disk\" \"float radius\" .5", "\"rgb L\" [9 6 4] ");

/// An image for every environment that names "map", and for every texture: a bright spot on grey.
inline void add_map(Scene& scene) {
  Image map(16, 8, 3);
  for (float& v : map.pixels) v = 0.2f;
  for (int c = 0; c < 3; ++c) map.at(3, 1, c) = 30;
  scene.images.push_back({"map", map});
  for (Entity& entity : scene.lights) entity.image = entity.parameters.entries.contains("mapname") ? 0 : -1;
}

/// Looks from `eye` to `target`.
inline Scene view_of(const std::string& text, const glm::dvec3& eye, const glm::dvec3& target,
                     double fov_degrees, int side) {
  Scene scene = parse_world(text, {true, true, true});
  scene.film = {side, side, ""};
  scene.camera = camera_at(eye, target - eye, fov_degrees);
  add_map(scene);
  return scene;
}
/// Looks into the corner, at all three of its walls.
inline Scene corner_view(const std::string& text, int side = 4) {
  return view_of(text, {0.9, -0.9, 0.9}, {-1, 1, 0.3}, 40, side);
}

/// Indirect light alone. The limit is low, so that compensation has something to do all over the corner.
inline GlobalIlluminationJob global_job() {
  GlobalIlluminationJob job;
  job.sampler = job.direct.sampler = "random";
  job.direct.integrator_samples = 2;
  job.paths = 32;
  job.sets = 4;
  job.gather = 2;
  job.limit = 1;
  job.only_indirect = true;
  return job;
}

/// Mean of all channels of an image.
inline double mean_of(const Image& image) {
  double sum = 0;
  for (const float v : image.pixels) sum += v;
  return sum / double(image.pixels.size());
}

/// Mean and standard error of independent values.
inline Estimate estimate_of(const std::vector<double>& values) {
  Estimate e;
  for (const double v : values) e.mean += v / double(values.size());
  for (const double v : values) e.error += (v - e.mean) * (v - e.mean);
  e.error = std::sqrt(e.error / double(values.size() - 1) / double(values.size()));
  return e;
}

inline void set_seed(GlobalIlluminationJob& job, std::uint32_t seed) {
  job.direct.seed = seed;
}
inline void set_seed(PathTracingJob& job, std::uint32_t seed) {
  job.seed = seed;
}

/// Mean of the image, and its error by renders with `seeds` seeds.
template <typename AnyJob>
Estimate over_seeds(const Reference& reference, AnyJob job, int seeds) {
  std::vector<double> means;
  for (int s = 0; s < seeds; ++s) {
    set_seed(job, 100 + static_cast<std::uint32_t>(s));
    means.push_back(mean_of(reference.render(job).image));
  }
  return estimate_of(means);
}

}  // namespace capcon::test
