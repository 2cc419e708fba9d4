#include "bench/tracer_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>

#include "bench/embree_tracer.h"
#include "bench/geometry_triangles.h"
#include "layout.h"
#include "render/features.h"
#include "render/geometry.h"
#include "render/ray_caster.h"
#include "render/renderer_state.h"
#include "render/view.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

double cpu_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// In the order of the renderer's lanes: blocks of 4 x 2 pixels (shaders/dispatch.glsl).
std::vector<DeviceRay> primary_rays(const Scene& scene, const View& view) {
  const int width = scene.film.width, height = scene.film.height;
  std::vector<DeviceRay> rays;
  rays.reserve(std::size_t(width) * height);
  for (int top = 0; top < height; top += 2) {
    for (int left = 0; left < width; left += 4) {
      for (int y = top; y < std::min(top + 2, height); ++y) {
        for (int x = left; x < std::min(left + 4, width); ++x) {
          const glm::dvec3 from_corner = (x + 0.5) * view.across + (y + 0.5) * view.down;
          rays.push_back({glm::vec3(view.first + view.start * from_corner), 3e38f,
                          glm::vec3(glm::normalize(view.corner + from_corner))});
        }
      }
    }
  }
  return rays;
}

/// The scene without spheres and disks; counts them.
Scene only_triangles(const Scene& scene, std::uint64_t& left_out) {
  Scene meshes = scene;
  std::vector<std::uint64_t> round(scene.objects.size());
  const auto strip = [](std::vector<Shape>& shapes) {
    return std::erase_if(shapes, [](const Shape& s) { return s.kind != ShapeKind::mesh; });
  };
  left_out = strip(meshes.shapes);
  for (std::size_t o = 0; o < round.size(); ++o) round[o] = strip(meshes.objects[o].shapes);
  for (const Instance& instance : scene.instances) left_out += round[instance.object];
  return meshes;
}

/// Cosine-weighted rays from what the primary rays meet.
std::vector<DeviceRay> occlusion_rays(const Geometry& geometry, const std::vector<DeviceRay>& primary,
                                      const std::vector<DeviceHit>& hits, const TracerBenchOptions& options) {
  const TriangleLookup lookup(geometry);
  const auto sampler = make_sampler("random", options.samples, 1);
  std::vector<DeviceRay> rays;
  for (std::uint32_t pixel = 0; pixel < primary.size(); ++pixel) {
    if (hits[pixel].primitive == layout::kNoPrimitive) continue;
    const glm::dvec3 d(primary[pixel].direction);
    const auto v = lookup.vertices(hits[pixel].primitive);
    glm::dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]);
    if (!(glm::length(n) > 0)) continue;
    n = glm::normalize(n);
    if (glm::dot(n, d) > 0) n = -n;
    const glm::dvec3 p = glm::dvec3(primary[pixel].origin) + static_cast<double>(hits[pixel].t) * d;
    const glm::dvec3 origin = p + 1e-5 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) * n;
    const glm::dvec3 t =
        glm::normalize(std::abs(n.x) > 0.5 ? glm::dvec3(n.y, -n.x, 0) : glm::dvec3(0, n.z, -n.y));
    const glm::dvec3 b = glm::cross(n, t);
    for (std::uint32_t i = 0; i < options.samples; ++i) {
      const FixedPoint u = sampler->sample(pixel, i, 0, SampleDomain::disk);
      const double r = std::sqrt(to_unit_float(u.x)), phi = 2 * M_PI * to_unit_float(u.y);
      const glm::dvec3 w = r * std::cos(phi) * t + r * std::sin(phi) * b + std::sqrt(1 - r * r) * n;
      rays.push_back({glm::vec3(origin), static_cast<float>(options.radius), glm::vec3(glm::normalize(w)),
                      layout::kNoPrimitive});
    }
  }
  return rays;
}

/// Closest: same primitive, or the same distance. Any: both met something or neither did; a ray that ends or
/// starts within rounding of a surface may go either way, which `closest` (Embree's distances) shows.
void count_differences(TracerBenchRow& row, const std::vector<DeviceHit>& hits,
                       const std::vector<DeviceHit>& truth, bool any) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool met = hits[i].primitive != layout::kNoPrimitive,
               truly = truth[i].primitive != layout::kNoPrimitive;
    if (any ? met == truly : met == truly && (!met || hits[i].primitive == truth[i].primitive)) continue;
    ++row.different;
    if (!any && met && truly && std::abs(hits[i].t - truth[i].t) <= 1e-5 * std::abs(truth[i].t)) ++row.ties;
  }
}

class Bench {
 public:
  Bench(RendererState& state, const EmbreeTracer* embree, std::uint32_t repeats)
      : state_(state), embree_(embree), repeats_(repeats) {}

  void run(const std::string& name, const std::vector<DeviceRay>& rays, bool any, TracerBench& result,
           const std::function<void(double)>& on_progress) {
    RayCaster caster(state_, rays);
    caster.cast(any);  // compiles, and warms the caches
    std::vector<TracerBenchRow> rows(embree_ ? 4 : 1);
    const char* names[] = {"capcon", "embree single", "embree wide", "embree stream"};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows[k].rays = name;
      rows[k].tracer = names[k];
      rows[k].count = rays.size();
    }
    std::vector<std::vector<DeviceHit>> answers(rows.size());
    for (std::uint32_t r = 0; r < repeats_; ++r) {
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const double start = cpu_seconds();
        if (k == 0) {
          rows[k].device_seconds.push_back(caster.cast(any));
        } else {
          embree_->cast(rays, any, static_cast<EmbreeTracer::Call>(k - 1), answers[k]);
        }
        rows[k].cpu_seconds.push_back(cpu_seconds() - start);
      }
      for (auto& row : rows) {
        if (embree_) row.ratios.push_back(rows[1].cpu_seconds.back() / row.cpu_seconds.back());
      }
      on_progress((r + 1.0) / repeats_);
    }
    answers[0] = caster.hits();
    for (std::size_t k = 0; k < rows.size() && embree_; ++k)
      count_differences(rows[k], answers[k], answers[1], any);
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  }

 private:
  RendererState& state_;
  const EmbreeTracer* embree_;
  std::uint32_t repeats_;
};

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

TracerBench bench_tracer(const Scene& whole, const TracerBenchOptions& options,
                         const std::function<void(double)>& on_progress) {
  TracerBench result;
  const Scene scene = only_triangles(whole, result.left_out);
  Renderer renderer(scene, options.renderer);
  const auto start = std::chrono::steady_clock::now();
  const Placement& placement = renderer.state().placement;
  const bool two_level = wants_two_levels(scene, options.renderer.instancing);
  const Geometry geometry =
      build_geometry(scene, {.two_level = two_level, .keep_instances = two_level, .placement = placement});
  result.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.triangles = geometry.triangle_count;
  result.bytes_per_triangle = 16.0 *
                              static_cast<double>(geometry.bvh.texels.size() + geometry.primitives.size() +
                                                  geometry.instances.size()) /
                              static_cast<double>(std::max<std::uint64_t>(1, geometry.triangle_count));
  result.device = renderer.state().description.name;
  std::unique_ptr<EmbreeTracer> embree;
  if (EmbreeTracer::available()) {
    embree = std::make_unique<EmbreeTracer>(geometry);
    result.embree_build_seconds = embree->build_seconds();
  }
  Bench bench(renderer.state(), embree.get(), options.repeats);
  const auto primary = primary_rays(scene, renderer.state().view);
  bench.run("primary", primary, false, result, [&](double f) { on_progress(0.2 * f); });
  RayCaster caster(renderer.state(), primary);
  caster.cast(false);
  TracerBenchOptions placed = options;
  placed.radius *= placement.scale;
  bench.run("occlusion", occlusion_rays(geometry, primary, caster.hits(), placed), true, result,
            [&](double f) { on_progress(0.2 + 0.8 * f); });
  result.compile_seconds = renderer.state().kernels.take_compile_seconds();
  return result;
}

}  // namespace capcon
