#include "render/features.h"

#include <algorithm>

namespace capcon {
namespace {

bool has_quadric(const std::vector<Shape>& shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& s) { return s.kind != ShapeKind::mesh; });
}

}  // namespace

Features needed_features(const Scene& scene, const Job* job, const std::string& instancing) {
  Features f;
  f.quadrics = has_quadric(scene.shapes) ||
               std::any_of(scene.instances.begin(), scene.instances.end(),
                           [&](const Instance& i) { return has_quadric(scene.objects[i.object].shapes); });
  f.two_level = wants_two_levels(scene, instancing);
  if (!job) return f;
  f.jittered = position_of(*job) == PixelPosition::jittered;
  f.shading = needs_shading(*job);
  return f;
}

Features all_features(const Scene&, const std::string&) {
  return {true, true, true, true};
}

namespace {

/// Shadow rays and the like a pixel, about.
double rays_a_pixel(const Job& job) {
  if (const auto* occlusion = std::get_if<AmbientOcclusionJob>(&job)) return occlusion->samples;
  if (const auto* direct = std::get_if<DirectLightingJob>(&job)) return 2.0 * direct->samples();
  if (const auto* igi = std::get_if<GlobalIlluminationJob>(&job)) {
    constexpr double kHitsAPath = 2.5;
    return 2.0 * igi->direct.samples() + kHitsAPath * igi->paths * igi->sets_a_pixel();
  }
  return std::get<PathTracingJob>(job).samples;
}

}  // namespace

ReadOptions needed_reading(const Job& job, bool keep_everything) {
  const bool all = keep_everything || needs_shading(job);
  return {all, all, all};
}

bool wants_two_levels(const Scene& scene, const std::string& instancing) {
  if (instancing != "auto") return instancing == "two-level";
  // Above this size the build and the memory of one tree cost more than its faster walk brings back.
  constexpr std::uint64_t kSmall = 2'000'000;
  const std::uint64_t all = scene.instanced_triangles();
  return all > kSmall && all >= 2 * scene.unique_triangles();
}

bool wants_best_tree(const Scene& scene, bool keep_instances, const Job* job, const std::string& tree) {
  if (tree != "auto" || !job) return tree != "fast";
  constexpr double kRaysATriangle = 60;
  const double rays = double(scene.film.width) * scene.film.height * rays_a_pixel(*job);
  const std::uint64_t triangles = keep_instances ? scene.unique_triangles() : scene.instanced_triangles();
  return rays >= kRaysATriangle * static_cast<double>(triangles);
}

}  // namespace capcon
