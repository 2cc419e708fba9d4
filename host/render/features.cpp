#include "render/features.h"

#include <algorithm>

namespace capcon {
namespace {

bool has_quadric(const std::vector<Shape>& shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& s) { return s.kind != ShapeKind::mesh; });
}

}  // namespace

Features needed_features(const Scene& scene, const AmbientOcclusionJob* job, const std::string& instancing) {
  Features f;
  f.quadrics = has_quadric(scene.shapes) ||
               std::any_of(scene.instances.begin(), scene.instances.end(),
                           [&](const Instance& i) { return has_quadric(scene.objects[i.object].shapes); });
  f.two_level = wants_two_levels(scene, instancing);
  f.jittered = job && job->position == PixelPosition::jittered;
  return f;
}

Features all_features(const Scene&, const std::string&) {
  return {true, true, true, true, true};
}

ReadOptions needed_reading(bool keep_everything) {
  return {keep_everything, keep_everything, keep_everything};
}

bool wants_two_levels(const Scene& scene, const std::string& instancing) {
  if (instancing != "auto") return instancing == "two-level";
  // Above this size the build and the memory of one tree cost more than its faster walk brings back.
  constexpr std::uint64_t kSmall = 2'000'000;
  const std::uint64_t all = scene.instanced_triangles();
  return all > kSmall && all >= 2 * scene.unique_triangles();
}

bool wants_best_tree(const Scene& scene, bool keep_instances, const AmbientOcclusionJob* job,
                     const std::string& tree) {
  if (tree != "auto" || !job) return tree != "fast";
  constexpr double kRaysATriangle = 60;
  const double rays = double(scene.film.width) * scene.film.height * job->samples;
  const std::uint64_t triangles = keep_instances ? scene.unique_triangles() : scene.instanced_triangles();
  return rays >= kRaysATriangle * static_cast<double>(triangles);
}

}  // namespace capcon
