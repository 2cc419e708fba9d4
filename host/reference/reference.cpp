#include "reference/reference.h"

#include <atomic>
#include <cassert>
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>

#include "base/parallel.h"
#include "reference/hemisphere.h"
#include "reference/tree.h"
#include "reference/view.h"
#include "sampling/sampler.h"

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
  explicit State(const Scene& scene)
      : primitives(scene), tree(primitives), view(scene.camera, scene.film), film(scene.film) {
    // A surface point is exact to a few ulps of its primitive's coordinates; 64 ulps of the largest keep it
    // outside.
    offset = 64 * 0x1p-52 * tree.scale();
  }

  /// The point that the ray sees, with its normal turned towards the viewer, ready for rays that leave it.
  struct Seen {
    SurfacePoint at;
    std::uint32_t ignored;
  };
  std::optional<Seen> look(const Ray& ray) const {
    const std::optional<Hit> hit = tree.closest(ray);
    if (!hit) return {};
    SurfacePoint at = primitives.surface(hit->primitive, ray, hit->t);
    if (glm::dot(at.normal, ray.direction) > 0) at.normal = -at.normal;
    at.position += offset * at.normal;
    return Seen{at, primitives.flat(hit->primitive) ? hit->primitive : Tree::kNone};
  }

  bool visible(const Seen& seen, FixedPoint point, double radius) const {
    const glm::dvec3 local = cosine_hemisphere(to_unit(point.x), to_unit(point.y));
    const glm::dvec3 direction = glm::normalize(around_normal(seen.at.normal, local));
    return !tree.occluded({seen.at.position, direction}, radius, seen.ignored);
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
        seen = look(view.ray(x + to_unit(place.x), y + to_unit(place.y)));
      } else if (i == 0) {
        seen = look(view.ray(x + 0.5, y + 0.5));
      }
      if (!seen) continue;
      ++count.rays;
      if (visible(*seen, sampler.sample(pixel, i, kOcclusionPair, SampleDomain::disk), job.radius))
        ++count.visible;
    }
    return count;
  }

  Primitives primitives;
  Tree tree;
  View view;
  Film film;
  double offset = 0;
  Timings setup;
};

Reference::Reference(const Scene& scene) {
  const Stopwatch watch;
  state_ = std::make_unique<State>(scene);
  state_->setup.wall["build"] = watch.seconds();
}

Reference::~Reference() = default;

const Timings& Reference::setup() const {
  return state_->setup;
}

RenderResult Reference::render(const AmbientOcclusionJob& job,
                               const std::function<void(double)>& on_progress) const {
  assert(job.samples >= 1 && job.radius > 0);
  const Film& film = state_->film;
  RenderResult result;
  result.device = "reference";
  const Stopwatch points_watch;
  const std::unique_ptr<Sampler> sampler = make_sampler(job.sampler, job.samples, job.seed);
  result.timings.wall["points"] = points_watch.seconds();

  const Stopwatch trace_watch;
  result.image = Image(film.width, film.height, 1);
  std::atomic<std::uint64_t> rays{0};
  std::atomic<int> rows{0};
  const std::thread::id caller = std::this_thread::get_id();
  parallel_for(static_cast<std::size_t>(film.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    std::uint64_t row_rays = 0;
    for (int x = 0; x < film.width; ++x) {
      const State::Count count = state_->count_pixel(job, *sampler, x, y);
      result.image.at(x, y, 0) = static_cast<float>(count.visible) / static_cast<float>(job.samples);
      row_rays += count.rays;
    }
    rays += row_rays;
    const int done = ++rows;
    if (on_progress && std::this_thread::get_id() == caller) on_progress(double(done) / film.height);
  });
  if (on_progress) on_progress(1);
  result.rays = rays;
  result.timings.wall["trace"] = trace_watch.seconds();
  return result;
}

}  // namespace capcon
