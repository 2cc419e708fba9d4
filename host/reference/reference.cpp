#include "reference/reference.h"

#include <atomic>
#include <cassert>
#include <chrono>
#include <mutex>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "reference/direct_lighting.h"
#include "reference/global_illumination.h"
#include "reference/hemisphere.h"
#include "reference/light_paths.h"
#include "reference/path_tracing.h"

namespace capcon {
namespace {

using namespace reference;

// Dimension pairs of the sampler.
constexpr std::uint32_t kOcclusionPair = 0;
constexpr std::uint32_t kPixelPair = 1;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

double to_unit(std::uint32_t word) {
  return static_cast<double>(word >> 8) / 16777216.0;
}

}  // namespace

struct Reference::State {
  explicit State(const Scene& s) : scene(s), geometry(s), view(s.camera, s.film), film(s.film) {}

  bool visible(const Seen& seen, FixedPoint point, double radius) const {
    const glm::dvec3 local = cosine_hemisphere(to_unit(point.x), to_unit(point.y));
    const glm::dvec3 direction = glm::normalize(around_normal(seen.at.normal, local));
    return !geometry.tree.occluded({seen.at.position, direction}, radius, {seen.ignored});
  }

  struct Count {
    std::uint32_t visible = 0;
    std::uint32_t rays = 0;
  };
  Count count_pixel(const AmbientOcclusionJob& job, const Sampler& sampler, int x, int y) const {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(film.width) +
                       static_cast<std::uint32_t>(x);
    Count count;
    std::optional<Seen> seen;
    for (std::uint32_t i = 0; i < job.samples; ++i) {
      if (job.position == PixelPosition::jittered) {
        const FixedPoint place = sampler.sample(pixel, i, kPixelPair);
        seen = geometry.look(view.ray(x + to_unit(place.x), y + to_unit(place.y)));
      } else if (i == 0) {
        seen = geometry.look(view.ray(x + 0.5, y + 0.5));
      }
      if (!seen) continue;
      ++count.rays;
      if (visible(*seen, sampler.sample(pixel, i, kOcclusionPair, SampleDomain::disk), job.radius))
        ++count.visible;
    }
    return count;
  }

  /// Calls pixel(x, y), which returns the rays that it traced, for all of the film.
  template <typename Pixel>
  void trace(RenderResult& result, const std::function<void(double)>& on_progress, const Pixel& pixel) const {
    const Stopwatch watch;
    std::atomic<std::uint64_t> rays{0};
    std::atomic<int> rows{0};
    const std::thread::id caller = std::this_thread::get_id();
    parallel_for(static_cast<std::size_t>(film.height), [&](std::size_t row) {
      std::uint64_t row_rays = 0;
      for (int x = 0; x < film.width; ++x) row_rays += pixel(x, static_cast<int>(row));
      rays += row_rays;
      const int done = ++rows;
      if (on_progress && std::this_thread::get_id() == caller) on_progress(double(done) / film.height);
    });
    if (on_progress) on_progress(1);
    result.rays = rays;
    result.timings.wall["trace"] = watch.seconds();
  }

  /// Makes the image of what estimate(x, y) says of each pixel.
  template <typename Estimate>
  void trace_radiance(RenderResult& result, const std::function<void(double)>& on_progress,
                      const Estimate& estimate) const {
    result.device = "reference";
    result.image = Image(film.width, film.height, 3);
    trace(result, on_progress, [&](int x, int y) {
      const DirectLighting::Estimate pixel = estimate(x, y);
      for (int c = 0; c < 3; ++c) result.image.at(x, y, c) = static_cast<float>(pixel.radiance[c]);
      return pixel.rays;
    });
  }

  const DirectLighting& lighting() {
    std::call_once(lighting_once, [&] { direct = std::make_unique<DirectLighting>(scene, geometry); });
    return *direct;
  }

  const Scene& scene;
  Geometry geometry;
  View view;
  Film film;
  Timings setup;
  std::once_flag lighting_once;
  std::unique_ptr<DirectLighting> direct;
};

Reference::Reference(const Scene& scene) {
  const Stopwatch watch;
  state_ = std::make_unique<State>(scene);
  state_->setup.wall["build"] = watch.seconds();
}

Reference::~Reference() = default;

std::vector<std::string> Reference::warnings() const {
  return state_->direct ? state_->direct->warnings() : std::vector<std::string>();
}

const Timings& Reference::setup() const {
  return state_->setup;
}

RenderResult Reference::render(const AmbientOcclusionJob& job,
                               const std::function<void(double)>& on_progress) const {
  assert(job.samples >= 1 && job.radius > 0);
  RenderResult result;
  result.device = "reference";
  const Stopwatch watch;
  const std::unique_ptr<Sampler> sampler =
      make_sampler(job.sampler, job.samples, job.seed, 1, state_->film.width);
  result.timings.wall["points"] = watch.seconds();
  result.image = Image(state_->film.width, state_->film.height, 1);
  state_->trace(result, on_progress, [&](int x, int y) {
    const State::Count count = state_->count_pixel(job, *sampler, x, y);
    result.image.at(x, y, 0) = static_cast<float>(count.visible) / static_cast<float>(job.samples);
    return count.rays;
  });
  return result;
}

RenderResult Reference::render(const DirectLightingJob& job,
                               const std::function<void(double)>& on_progress) const {
  assert(job.image_samples >= 1 && job.integrator_samples >= 1);
  RenderResult result;
  const Stopwatch lighting_watch;
  const DirectLighting& lighting = state_->lighting();
  result.timings.wall["lighting"] = lighting_watch.seconds();
  const Stopwatch points_watch;
  const DirectPoints points(job, state_->film.width);
  result.timings.wall["points"] = points_watch.seconds();
  state_->trace_radiance(result, on_progress, [&](int x, int y) {
    return lighting.pixel(job, points, state_->view, state_->film.width, x, y);
  });
  return result;
}

RenderResult Reference::render(const GlobalIlluminationJob& job,
                               const std::function<void(double)>& on_progress) const {
  const Stopwatch watch;
  const VirtualLights lights = trace_virtual_lights(job);
  const double seconds = watch.seconds();
  RenderResult result = render(job, lights, on_progress);
  result.timings.wall["paths"] = seconds;
  return result;
}

RenderResult Reference::render(const GlobalIlluminationJob& job, const VirtualLights& lights,
                               const std::function<void(double)>& on_progress) const {
  check_job(job);
  assert(lights.sets() == job.sets);
  GlobalIlluminationJob limited = job;
  if (limited.limit == 0) limited.limit = default_geometry_limit(state_->scene);
  const Stopwatch points_watch;
  const GlobalIllumination illumination(state_->geometry, state_->lighting(), limited, lights,
                                        state_->film.width);
  RenderResult result;
  result.timings.wall["points"] = points_watch.seconds();
  result.virtual_lights = lights.lights.size();
  state_->trace_radiance(result, on_progress, [&](int x, int y) {
    return illumination.pixel(state_->view, state_->film.width, x, y);
  });
  return result;
}

RenderResult Reference::render(const PathTracingJob& job,
                               const std::function<void(double)>& on_progress) const {
  assert(job.samples >= 1);
  const DirectLighting& lighting = state_->lighting();
  const PathTracing paths(state_->geometry, lighting.vertices(), lighting.lights());
  RenderResult result;
  state_->trace_radiance(result, on_progress, [&](int x, int y) {
    return paths.pixel(job, state_->view, state_->film.width, x, y);
  });
  return result;
}

VirtualLights Reference::trace_virtual_lights(const GlobalIlluminationJob& job) const {
  check_job(job);
  return LightPaths(state_->scene, state_->geometry, state_->lighting(), job).all();
}

RenderResult Reference::render(const Job& job, const std::function<void(double)>& on_progress) const {
  const auto* occlusion = std::get_if<AmbientOcclusionJob>(&job);
  const auto* direct = std::get_if<DirectLightingJob>(&job);
  if ((occlusion && !occlusion->share.whole()) || (direct && !direct->share.whole()))
    throw InputError("the reference makes whole images alone: leave out mpirun, or --device reference");
  return std::visit([&](const auto& j) { return render(j, on_progress); }, job);
}

}  // namespace capcon
