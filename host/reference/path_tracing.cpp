#include "reference/path_tracing.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "base/hash.h"
#include "shading/spectrum.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;

constexpr std::uint32_t kSeed = 0x65796521;
constexpr std::uint32_t kMostSurfaces = 1000;
constexpr std::uint32_t kCertainSurfaces = 4;  ///< from here on paths end by chance
constexpr double kMostLikely = 0.95;
/// How much of the way to a light is looked at.
constexpr double kWay = 1 - 0x1p-17;

// What the numbers of a surface are for.
constexpr std::uint32_t kPlace = 0, kDirection = 1, kLights = 2;

}  // namespace

/// Independent numbers in [0, 1), addressed by the surface of a path and their use.
class PathTracing::Numbers {
 public:
  Numbers(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
      : seed_(seed ^ kSeed), pixel_(pixel), sample_(sample) {}

  std::array<double, 4> operator()(std::uint32_t surface, std::uint32_t use) const {
    const auto words = pcg4d(pixel_, sample_, surface << 16 | use, seed_);
    std::array<double, 4> numbers;
    for (int k = 0; k < 4; ++k) numbers[k] = words[k] * 0x1p-32;
    return numbers;
  }

 private:
  std::uint32_t seed_, pixel_, sample_;
};

dvec3 PathTracing::next_event(const Vertex& vertex, const Numbers& numbers, std::uint32_t surface,
                              std::uint64_t& rays) const {
  dvec3 sum(0);
  for (int j = 0; j < lights_.count(); ++j) {
    const auto u = numbers(surface, kLights + static_cast<std::uint32_t>(j));
    const auto light = lights_.sample(j, vertex.at.position, vertex.at.normal, {u[0], u[1]});
    if (!light) continue;
    const dvec3 in = vertex.frame.to_local(light->direction);
    const dvec3 reflected = vertex.reflect(light->direction, in);
    if (reflected == dvec3(0)) continue;
    ++rays;
    const Ray ray(vertex.at.position, light->direction);
    if (geometry_.tree.occluded(ray, light->distance * kWay, {vertex.ignored, light->first, light->count}))
      continue;
    const double other = lights_.findable(j) ? vertex.bsdf.pdf(in, vertex.out) : 0;
    sum += reflected * light->radiance / (light->pdf * (1 + other / light->pdf));
  }
  return sum;
}

dvec3 PathTracing::met(const Ray& ray, const std::optional<Seen>& seen, const Vertex* vertex,
                       double pdf) const {
  if (!vertex && !seen) return lights_.background(ray.direction);
  const auto weight = [&](double light_pdf) { return vertex ? 1 / (1 + light_pdf / pdf) : 1; };
  dvec3 sum(0);
  if (seen) {
    const int light = lights_.of_primitive(seen->primitive);
    if (light < 0) return sum;
    const LightMet found = lights_.meet(light, seen->primitive, ray, seen->t);
    return found.radiance == dvec3(0) ? sum : found.radiance * weight(found.pdf);
  }
  for (int j = 0; j < lights_.count(); ++j) {
    if (lights_.lights().values[j].kind != LightKind::environment) continue;
    const LightMet found = lights_.environment(j, vertex->at.normal, ray.direction);
    sum += found.radiance * weight(found.pdf);
  }
  return sum;
}

dvec3 PathTracing::path(const Ray& from_eye, const Numbers& numbers, bool only_indirect,
                        std::uint64_t& rays) const {
  std::optional<Seen> seen = geometry_.look(from_eye);
  dvec3 sum = only_indirect ? dvec3(0) : met(from_eye, seen, nullptr, 0);
  dvec3 throughput(1);
  dvec3 out = -from_eye.direction;
  for (std::uint32_t surface = 0; seen && surface < kMostSurfaces; ++surface) {
    const Vertex vertex = vertices_.at(*seen, out);
    const bool counts = !only_indirect || surface > 0;
    if (counts) sum += throughput * next_event(vertex, numbers, surface, rays);
    const auto u = numbers(surface, kDirection);
    const auto next = continue_from(vertex, {u[0], u[1]}, u[2]);
    if (!next) break;
    throughput *= next->reflected / next->pdf;
    if (surface + 1 >= kCertainSurfaces) {
      const double goes_on = std::min(kMostLikely, luminance(throughput));
      if (!(u[3] < goes_on)) break;
      throughput /= goes_on;
    }
    ++rays;
    const Ray ray(vertex.at.position, next->direction);
    seen = geometry_.look(ray, {vertex.ignored});
    if (counts) sum += throughput * met(ray, seen, &vertex, next->pdf);
    out = -next->direction;
  }
  return sum;
}

DirectLighting::Estimate PathTracing::pixel(const PathTracingJob& job, const View& view, int width, int x,
                                            int y) const {
  const auto pixel =
      static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x);
  DirectLighting::Estimate estimate;
  for (std::uint32_t i = 0; i < job.samples; ++i) {
    const Numbers numbers(job.seed, pixel, i);
    glm::dvec2 place(0.5);
    if (job.position == PixelPosition::jittered) {
      const auto u = numbers(0, kPlace);
      place = {u[0], u[1]};
    }
    const Ray ray = view.ray(x + place.x, y + place.y);
    estimate.radiance += path(ray, numbers, job.only_indirect, estimate.rays);
  }
  estimate.radiance /= static_cast<double>(job.samples);
  return estimate;
}

}  // namespace capcon::reference
