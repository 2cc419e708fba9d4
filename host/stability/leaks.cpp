#include <fmt/format.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/hash.h"
#include "base/parallel.h"
#include "render/ray_caster.h"
#include "render/renderer_state.h"
#include "stability/checks.h"
#include "stability/closed_mesh.h"

namespace capcon::stability {
namespace {

constexpr std::uint64_t kBatch = 1u << 20;

/// Rays of a batch from within the mesh (placed by `to_device`): every other one at a vertex, the rest at
/// points of edges.
std::vector<DeviceRay> rays_at_edges(const TriangleMesh& mesh, const glm::dmat4& to_device,
                                     std::uint64_t first, std::uint64_t count) {
  std::vector<DeviceRay> rays(count);
  parallel_for(
      count,
      [&](std::size_t i) {
        const std::uint64_t n = first + i;
        const auto random = [&](int k) { return uniform64(23, n, k); };
        const auto placed = [&](const glm::dvec3& p) { return glm::dvec3(to_device * glm::dvec4(p, 1)); };
        const glm::uvec3& t = mesh.triangles[n % mesh.triangles.size()];
        const glm::dvec3 a = mesh.positions[t[n % 3]], b = mesh.positions[t[(n + 1) % 3]];
        const double share = n % 2 == 0 ? 0 : random(0);
        const glm::dvec3 inside = 0.5 * glm::dvec3(random(1) - 0.5, random(2) - 0.5, random(3) - 0.5);
        rays[i].origin = glm::vec3(placed(inside));
        rays[i].direction =
            glm::vec3(glm::normalize(placed(a + share * (b - a)) - glm::dvec3(rays[i].origin)));
      },
      4096);
  return rays;
}

Check run(const std::string& name, const std::string& what, bool instances, const glm::dmat4& place,
          const Workshop& workshop, std::uint64_t rays) {
  const auto start = std::chrono::steady_clock::now();
  Scene scene;
  scene.name = "closed";
  scene.film = {16, 16, ""};
  scene.meshes.push_back(closed_mesh(4, 5));
  Shape shape;
  shape.to_world = place;
  if (instances) {
    scene.objects.push_back({"closed", {Shape{}}});
    scene.instances.push_back({0, place});
  } else {
    scene.shapes.push_back(shape);
  }
  scene.camera.camera_to_world = place;
  RendererOptions options;
  options.device = workshop.device;
  options.instancing = instances ? "two-level" : "flat";
  Renderer renderer(scene, options);
  const glm::dmat4 to_device = renderer.state().placement.matrix() * place;
  Check check;
  check.group = "geometry";
  check.name = name;
  check.what = what;
  check.bound = "no ray gets out";
  check.reason = "triangles that share an edge see the same numbers there, and zero counts as inside";
  for (std::uint64_t first = 0, batch = 0; first < rays; first += kBatch, ++batch) {
    const auto cast = rays_at_edges(scene.meshes[0], to_device, first, std::min(kBatch, rays - first));
    RayCaster caster(renderer.state(), cast);
    caster.cast(batch % 2 == 1);
    for (const DeviceHit& hit : caster.hits()) {
      ++check.values;
      if (hit.primitive == 0xffffffffu) ++check.beyond;
    }
  }
  check.measured = fmt::format("{} of {:.0e} leak", check.beyond, static_cast<double>(check.values));
  check.passed = check.beyond == 0;
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> leak_tasks(const Workshop& workshop, std::uint64_t rays) {
  const glm::dmat4 turned =
      glm::scale(glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(3, -2, 1)), 0.7, glm::dvec3(1, .4, .2)),
                 glm::dvec3(1.3, .8, 1));
  std::vector<Task> tasks;
  const auto add = [&](const std::string& name, const std::string& what, bool instances,
                       const glm::dmat4& place, std::uint64_t count) {
    tasks.push_back({"geometry", name, [=] { return run(name, what, instances, place, workshop, count); }});
  };
  add("watertight", "rays at edges and vertices of a closed mesh of 5,120 triangles", false, glm::dmat4(1),
      rays);
  add("watertight-instance", "the same as a turned instance", true, turned, rays / 8);
  return tasks;
}

}  // namespace capcon::stability
